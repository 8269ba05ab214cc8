#include "image/image_store.h"

#include "image/decode.h"

namespace rb {

ImagePtr ImageStore::read(const std::string& path, ImageType type) {
    ImagePtr& image = images_[{path, type}];
    if (!image) image = std::make_shared<const Image>(decode_image(path, type));
    return image;
}

}  // namespace rb
