#include "base/temporary_file.h"

#include <cstdio>
#include <unistd.h>

namespace rb {

TemporaryFile::TemporaryFile(const std::string& path)
    : name_(path + "." + std::to_string(getpid()) + ".part") {}

TemporaryFile::~TemporaryFile() {
    if (!name_.empty()) std::remove(name_.c_str());
}

bool TemporaryFile::put_in_place(const std::string& path) {
    if (std::rename(name_.c_str(), path.c_str()) != 0) return false;
    name_.clear();
    return true;
}

}  // namespace rb
