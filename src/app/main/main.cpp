#include "app/commands.h"

int main(int argc, char** argv) { return rb::run({argv + 1, argv + argc}, argv[0]); }
