// blob { [threshold F] (sphere { <C>, R, [strength] S ... } | cylinder { <A>, <B>, R, [strength] S ... } |
//        component S, R, <C>)... }   (manual 3.5.1.1); components have transformations and textures of their
//        own
#include "shapes/blob.h"

#include "shapes/frame.h"
#include "shapes/registry.h"

#include <algorithm>

namespace rb {

namespace {

class Collector {
public:
    BlobData blob;

    void add_sphere(BlockReader& in) {
        const Vec3 center = in.vec3();
        const double radius = in.number();
        BlobComponent c;
        c.object_from_local = placed(Transform{}, radius, center);
        finish(in, c, radius);
    }

    void add_cylinder(BlockReader& in) {
        const SourceRange at = in.where();
        const Vec3 a = in.vec3();
        const Vec3 axis = in.vec3() - a;
        const double length = glm::length(axis);
        if (!(length > 0.0)) in.fail_at(at, "Degenerate cylindrical component in blob.");
        const double radius = in.number();
        BlobComponent c;
        if (radius != 0.0) {
            c.length = length / std::abs(radius);
            c.object_from_local =
                placed(axial_frame(Vec3{0.0}, axis / length, 1.0).object_from_local, radius, a);
        }
        finish(in, c, radius);
    }

    void add_old(BlockReader& in) {
        BlobComponent c;
        c.strength = in.number();
        const double radius = in.number();
        c.object_from_local = placed(Transform{}, radius, in.vec3());
        keep(c, radius);
    }

private:
    static Transform placed(const Transform& turned, double radius, const Vec3& origin) {
        if (radius == 0.0) return {};
        return then(then(turned, Transform::scaling(Vec3{std::abs(radius)})), Transform::translation(origin));
    }

    void finish(BlockReader& in, BlobComponent& c, double radius) {
        in.take_word("strength");
        c.strength = in.number();
        TexturePtr texture;
        while (!in.at_end()) {
            Transform map;
            if (in.context().take_transformation(in, map)) {
                c.object_from_local = then(c.object_from_local, map);
                if (texture) texture = transformed(texture, map);
            } else if (!in.context().take_texture(in, texture)) {
                break;
            }
        }
        in.finish();
        if (texture) {
            c.texture = static_cast<uint32_t>(blob.textures.size());
            blob.textures.push_back(std::move(texture));
        }
        keep(c, radius);
    }

    /// A component without size or strength has no field anywhere.
    void keep(const BlobComponent& c, double radius) {
        ++count_;
        if (radius != 0.0 && c.strength != 0.0) blob.components.push_back(c);
    }

public:
    bool is_empty() const { return count_ == 0; }

private:
    size_t count_ = 0;
};

ShapePtr read(BlockReader& in) {
    Collector collector;
    for (;;) {
        if (in.take_word("threshold")) {
            collector.blob.threshold = in.number();
        } else if (in.at_block("sphere")) {
            BlockReader part(in.block("sphere"), in.context());
            collector.add_sphere(part);
        } else if (in.at_block("cylinder")) {
            BlockReader part(in.block("cylinder"), in.context());
            collector.add_cylinder(part);
        } else if (in.take_word("component")) {
            collector.add_old(in);
        } else {
            break;
        }
    }
    if (collector.is_empty()) in.fail("Need at least one component in a blob.");
    return std::make_shared<Blob>(std::move(collector.blob));
}

}  // namespace

namespace shapes {
extern const ShapeKind blob;
const ShapeKind blob{
    "blob", read,
    "blob { threshold 0.5 sphere { <-0.3, 0, 0>, 0.8, 1 } cylinder { <0.2, -0.3, 0>, <0.5, 0.4, 0.2>, "
    "0.6, 0.9 scale <1, 1, 1.3> } sphere { <0, 0.5, -0.3>, 0.4, strength -0.5 } }"};
}  // namespace shapes

}  // namespace rb
