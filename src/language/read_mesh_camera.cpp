// mesh_camera { RAYS DISTRIBUTION [MAX_DISTANCE] mesh { ... } ... [smooth] }. Geometry spec 18.4.
#include "language/read_mesh_camera.h"

#include "language/read.h"
#include "shapes/mesh_shape.h"

#include <fmt/format.h>

namespace rb {

namespace {

CameraMesh mesh_of(const Object& object, SourceRange at, const BlockReader& in) {
    const auto* shape = std::get_if<ShapePtr>(&object.geometry);
    const auto mesh = shape ? std::dynamic_pointer_cast<const MeshShape>(*shape) : nullptr;
    if (!mesh) in.fail_at(at, "A mesh_camera takes meshes only.");
    const MeshData& data = mesh->data();
    return {{mesh, &data.triangles}, {mesh, &data.uvs}, {mesh, &data.face_uvs}, object.world_from_object};
}

RayDistribution distribution(BlockReader& in) {
    const SourceRange at = in.where();
    const int method = in.integer();
    if (method < 0 || method > 3) in.fail_at(at, "Unrecognized distribution method.");
    return static_cast<RayDistribution>(method);
}

}  // namespace

std::shared_ptr<const MeshCamera> read_mesh_camera(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    auto camera = std::make_shared<MeshCamera>();
    const SourceRange at = in.where();
    camera->rays_per_pixel = in.integer();
    if (camera->rays_per_pixel < 1) in.fail_at(at, "A pixel needs at least one ray.");
    camera->distribution = distribution(in);
    const bool is_single = camera->distribution == RayDistribution::side_by_side ||
                           camera->distribution == RayDistribution::by_uv;
    if (is_single && camera->rays_per_pixel > 1) {
        in.fail_at(at, "Distribution methods 2 and 3 take one ray per pixel.");
    }
    if (in.at_number()) camera->max_distance = in.number();
    while (in.at_block("mesh") || in.at_block("mesh2") || in.at_thing<ObjectPtr>()) {
        const SourceRange mesh_at = in.where();
        const ObjectPtr object =
            in.at_thing<ObjectPtr>() ? in.thing<ObjectPtr>() : read_object(in.block(in.peek_word()), context);
        camera->meshes.push_back(mesh_of(*object, mesh_at, in));
    }
    if (camera->meshes.empty())
        in.fail(fmt::format("Expected 'mesh or mesh2', {} found instead", in.found()));
    if (camera->distribution == RayDistribution::mesh_per_ray &&
        camera->meshes.size() < static_cast<size_t>(camera->rays_per_pixel)) {
        in.fail_at(at, "Distribution method 0 needs a mesh for each ray of a pixel.");
    }
    const SourceRange smooth_at = in.where();
    camera->smooth = in.take_word("smooth");
    if (camera->smooth && camera->distribution != RayDistribution::by_uv) {
        in.fail_at(smooth_at, "Only distribution method 3 takes 'smooth'.");
    }
    in.finish();
    return camera;
}

}  // namespace rb
