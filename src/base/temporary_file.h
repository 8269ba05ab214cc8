#pragma once
#include <string>

namespace rb {

/// The name under which a file is written until all of it is there. Unless it was put in its place, it is
/// removed: an error leaves nothing half-written behind.
class TemporaryFile {
public:
    /// Beside `path`.
    explicit TemporaryFile(const std::string& path);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& name() const { return name_; }
    /// Takes the place of `path`; false if that cannot be, with errno.
    bool put_in_place(const std::string& path);

private:
    std::string name_;
};

}  // namespace rb
