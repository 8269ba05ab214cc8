#include "stress.h"
namespace rb::stress {
const Family placement{"placement", "", [](const Effort&, Table&) {}};
}
