#pragma once
#include "scene/image.h"

#include <map>
#include <utility>

namespace rb {

/// The pictures that a scene has asked for, each decoded once.
class ImageStore final : public ImageFiles {
public:
    ImagePtr read(const std::string& path, ImageType type) override;
    void forget() override { images_.clear(); }

private:
    std::map<std::pair<std::string, ImageType>, ImagePtr> images_;
};

}  // namespace rb
