#pragma once
#include "app/settings.h"

namespace rb {

/// Writes every option that was given to the file that Create_Ini names, if it names one, so that the run can
/// be repeated with it.
void create_ini(const Settings& settings);

}  // namespace rb
