#include "stress.h"
namespace rb::stress {
const Family specks{"specks", "", [](const Effort&, Table&) {}};
}
