#include "stress.h"
namespace rb::stress {
const Family hard_cases{"hard_cases", "", [](const Effort&, Table&) {}};
}
