#include "app/commands.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

int main(int argc, char** argv) {
#ifdef __GLIBC__
    // Left alone, the threshold rises to the largest block that was freed (a scene's text), and from then on
    // large arrays leave holes in the heap instead of going back to the system.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
    return rb::run({argv + 1, argv + argc}, argv[0]);
}
