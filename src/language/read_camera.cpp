// camera. Language spec 20.1, geometry 18.1 and 18.2.
#include "language/read.h"
#include "language/read_mesh_camera.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr double tiny = 1e-10;

struct Kind {
    std::string_view word;
    CameraKind kind;
};
constexpr Kind kinds[] = {
    {"perspective", CameraKind::perspective}, {"orthographic", CameraKind::orthographic},
    {"fisheye", CameraKind::fisheye},         {"ultra_wide_angle", CameraKind::ultra_wide_angle},
    {"omnimax", CameraKind::omnimax},         {"panoramic", CameraKind::panoramic},
    {"cylinder", CameraKind::cylinder},       {"spherical", CameraKind::spherical}};

bool take_kind(BlockReader& in, Camera& camera) {
    if (in.at_block("mesh_camera")) {
        camera.kind = CameraKind::mesh_camera;
        camera.mesh = read_mesh_camera(in.block("mesh_camera"), in.context());
        in.context().session->experimental.insert("mesh camera");
        return true;
    }
    for (const Kind& kind : kinds) {
        if (!in.take_word(kind.word)) continue;
        camera.kind = kind.kind;
        if (kind.kind == CameraKind::cylinder) {
            const SourceRange at = in.where();
            camera.cylinder_type = in.integer();
            if (camera.cylinder_type < 1 || camera.cylinder_type > 4) {
                in.fail_at(at, "Cylinder camera type must be 1, 2, 3 or 4.");
            }
        }
        return true;
    }
    return false;
}

bool is_early(const BlockReader& in) { return in.context().language_version < 350; }

void scale_by_angle(Camera& camera) {
    const double wanted = glm::length(camera.right) / (2 * std::tan(camera.angle_deg * pi / 360));
    const double length = glm::length(camera.direction);
    if (length > 0) camera.direction *= wanted / length;
}

void look(BlockReader& in, CameraDraft& draft, SourceRange at) {
    Camera& camera = draft.camera;
    const double forward = glm::length(camera.direction);
    const double up = glm::length(camera.up);
    const double aside = glm::length(camera.right);
    const double handed = glm::dot(glm::cross(camera.up, camera.direction), camera.right);
    const Vec3 to = draft.look_at - camera.location;
    if (to == Vec3{0.0}) in.fail_at(at, "Camera location and look_at point must be different.");
    camera.direction = glm::normalize(to);
    Vec3 right = glm::cross(draft.sky, camera.direction);
    if (std::abs(right.x) < tiny && std::abs(right.y) < tiny && std::abs(right.z) < tiny) {
        in.diagnostics().warning(
            at, "Camera sky and view direction are parallel: the given right vector is used.");
        right = camera.right;
    }
    right = glm::normalize(right);
    camera.up = glm::cross(camera.direction, right) * up;
    camera.direction *= forward;
    camera.right = right * (handed > 0 ? aside : -aside);
}

void fit_orthographic(CameraDraft& draft) {
    Camera& camera = draft.camera;
    const double away = glm::length(draft.look_at - camera.location);
    const double forward = glm::length(camera.direction);
    if (away <= tiny || forward <= tiny) return;
    camera.right *= away / forward;
    camera.up *= away / forward;
}

bool take_vector(BlockReader& in, CameraDraft& draft) {
    Camera& camera = draft.camera;
    const SourceRange at = in.where();
    if (in.take_word("location")) {
        camera.location = in.vec3();
    } else if (in.take_word("direction")) {
        camera.direction = in.vec3();
    } else if (in.take_word("right")) {
        camera.right = in.vec3();
        draft.has_right_or_up = true;
    } else if (in.take_word("up")) {
        camera.up = in.vec3();
        draft.has_right_or_up = true;
    } else if (in.take_word("sky")) {
        draft.sky = in.vec3();
    } else if (in.take_word("look_at")) {
        draft.look_at = in.vec3();
        draft.has_look_at = true;
        if (is_early(in)) look(in, draft, at);
    } else {
        return false;
    }
    return true;
}

void take_angle(BlockReader& in, CameraDraft& draft) {
    Camera& camera = draft.camera;
    draft.angle_was_given = true;
    const SourceRange at = in.where();
    if (!in.at_number()) {
        if (camera.kind != CameraKind::orthographic)
            in.fail(fmt::format("Expected 'numeric expression', {} found instead", in.found()));
        return;
    }
    camera.angle_deg = in.number();
    draft.has_angle = camera.angle_deg != 0;
    if (camera.angle_deg < 0) in.fail_at(at, "Negative viewing angle.");
    const bool flat = camera.kind == CameraKind::perspective || camera.kind == CameraKind::orthographic;
    if (flat && camera.angle_deg >= 180) in.fail_at(at, "Viewing angle has to be smaller than 180 degrees.");
    if (camera.kind == CameraKind::spherical) {
        camera.vertical_angle_deg = camera.angle_deg / 2;
        if (in.at_number()) camera.vertical_angle_deg = in.number();
    }
    if (is_early(in) && camera.kind == CameraKind::perspective && draft.has_angle) scale_by_angle(camera);
}

PigmentPtr read_bokeh(const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    PigmentPtr pigment = read_pigment(in.block("pigment"), context, nullptr);
    in.finish();
    return pigment;
}

bool take_blur(BlockReader& in, CameraDraft& draft) {
    Camera& camera = draft.camera;
    const SourceRange at = in.where();
    if (in.take_word("aperture")) {
        camera.aperture = in.number();
    } else if (in.take_word("blur_samples")) {
        camera.blur_samples_min = 0;
        camera.blur_samples = in.integer();
        if (in.at_number() && !is_early(in)) {
            camera.blur_samples_min = camera.blur_samples;
            camera.blur_samples = in.integer();
        }
        if (camera.blur_samples <= 0) in.fail_at(at, "Illegal number of focal blur samples.");
        if (camera.blur_samples_min > camera.blur_samples) {
            in.fail_at(at, "Minimum number of focal blur samples must not exceed the maximum.");
        }
    } else if (in.take_word("focal_point")) {
        draft.focal_point = in.vec3();
        draft.has_focal_point = true;
    } else if (in.take_word("confidence")) {
        const double value = in.number();
        if (value > 0 && value < 1) {
            camera.confidence = value;
        } else {
            in.diagnostics().warning(at, "Illegal confidence value: the default is used.");
        }
    } else if (in.take_word("variance")) {
        const double value = in.number();
        if (value >= 0 && value <= 1) {
            camera.variance = value;
        } else {
            in.diagnostics().warning(at, "Illegal variance value: the default is used.");
        }
    } else if (in.at_block("bokeh")) {
        camera.bokeh = read_bokeh(in.block("bokeh"), in.context());
    } else if (in.at_block("normal")) {
        camera.normal = read_normal(in.block("normal"), in.context(), camera.normal);
    } else {
        return false;
    }
    return true;
}

void move(Camera& camera, const Transform& map) {
    camera.location = map.point(camera.location);
    camera.direction = map.direction(camera.direction);
    camera.up = map.direction(camera.up);
    camera.right = map.direction(camera.right);
}

void resolve(BlockReader& in, CameraDraft& draft, const Transform& map) {
    Camera& camera = draft.camera;
    const bool flat = camera.kind == CameraKind::perspective || camera.kind == CameraKind::orthographic;
    const bool early = is_early(in);
    const bool measured = (draft.has_angle && flat) || draft.has_look_at;
    if (!early && flat && draft.has_angle) scale_by_angle(camera);
    if (!early && draft.has_look_at) look(in, draft, in.block_where());
    if (camera.kind == CameraKind::orthographic && (!draft.has_right_or_up || draft.angle_was_given)) {
        fit_orthographic(draft);
    }
    camera.focal_distance = measured ? glm::length(camera.direction) : 1;
    if (draft.has_focal_point) camera.focal_distance = glm::length(draft.focal_point - camera.location);
    if (camera.focal_distance == 0) camera.focal_distance = 1;
    if (!early) move(camera, map);
    if (camera.mesh && camera.aperture != 0.0 && camera.blur_samples > 0) {
        in.diagnostics().warning(camera.where, "A mesh_camera has no lens: the aperture is left out.");
        camera.aperture = 0.0;
    }
    const bool skewed = std::abs(glm::dot(camera.direction, camera.up)) > tiny ||
                        std::abs(glm::dot(camera.direction, camera.right)) > tiny ||
                        std::abs(glm::dot(camera.up, camera.right)) > tiny;
    const bool tolerant = std::abs(glm::dot(camera.direction, camera.up)) > 1e-7 ||
                          std::abs(glm::dot(camera.direction, camera.right)) > 1e-7 ||
                          std::abs(glm::dot(camera.up, camera.right)) > 1e-7;
    if (skewed && tolerant) {
        in.diagnostics().warning(in.block_where(),
                                 "Camera vectors are not perpendicular. Making look_at the last "
                                 "statement may help.");
    }
    if (camera.kind == CameraKind::spherical && !draft.has_angle) {
        camera.angle_deg = 360;
        camera.vertical_angle_deg = 180;
    }
}

}  // namespace

void read_camera_draft(const Block& block, const ReadContext& context, CameraDraft& draft,
                       bool edits_default) {
    BlockReader in(block, context);
    draft.camera.where = block.where;
    Transform map;
    using Shared = std::shared_ptr<const Camera>;
    if (in.at_thing<Shared>()) {
        draft.camera = *in.thing<Shared>();
        draft.resolved = true;
        while (take_transformation(in, map)) {
        }
        in.finish();
        move(draft.camera, map);
        return;
    }
    while (take_kind(in, draft.camera)) {
    }
    while (!in.at_end()) {
        if (take_vector(in, draft) || take_blur(in, draft)) continue;
        if (draft.camera.kind != CameraKind::mesh_camera && in.take_word("angle")) {
            take_angle(in, draft);
            continue;
        }
        Transform step;
        if (!take_transformation(in, step)) break;
        if (is_early(in)) move(draft.camera, step);
        map = then(map, step);
    }
    in.finish();
    if (!edits_default) resolve(in, draft, map);
}

std::shared_ptr<const Camera> read_camera(const Block& block, const ReadContext& context) {
    CameraDraft draft = context.session->default_camera;
    read_camera_draft(block, context, draft, false);
    return std::make_shared<const Camera>(draft.camera);
}

}  // namespace rb
