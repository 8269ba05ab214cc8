#pragma once
#include "block/reader.h"
#include "language/session.h"

#include <string_view>

namespace rb {

// One reader per kind of statement: from generic blocks to the scene. What a reader does not take is an error
// at its place. `*_body` functions take what stands between the braces, which map entries have too.

bool is_object_keyword(std::string_view keyword);
/// Objects, cameras, global_settings, ...: what may stand at scene level before a `{`.
bool begins_statement(std::string_view keyword);
std::shared_ptr<Object> read_new_object(const Block& block, const ReadContext& context);
inline ObjectPtr read_object(const Block& block, const ReadContext& context) {
    return read_new_object(block, context);
}
LightPtr read_light(BlockReader& in);

TexturePtr read_texture(const Block& block, const ReadContext& context);
void read_texture_body(BlockReader& in, TextureLayers& layers);
/// `upper` on top of `lower` (may be null).
TexturePtr layered(const TexturePtr& lower, const TexturePtr& upper, SourceRange where);
/// Edits the top layer by a `pigment`, `normal` or `finish` statement.
void edit_texture(const Block& block, const ReadContext& context, TexturePtr& layers);

/// Takes a `texture`, `pigment`, `normal` or `finish` on top of `layers` (may be null) if one is next.
bool take_texture(BlockReader& in, TexturePtr& layers);

PigmentPtr read_pigment(const Block& block, const ReadContext& context, const PigmentPtr& base);
void read_pigment_body(BlockReader& in, Pigment& pigment);
NormalPtr read_normal(const Block& block, const ReadContext& context, const NormalPtr& base);
void read_normal_body(BlockReader& in, Normal& normal);
FinishPtr read_finish(const Block& block, const ReadContext& context, const FinishPtr& base);

std::shared_ptr<const ColorMap> read_color_map(const Block& block, const ReadContext& context);
PigmentMapPtr read_pigment_map(const Block& block, const ReadContext& context, bool average = false);
NormalMapPtr read_normal_map(const Block& block, const ReadContext& context, bool average = false);
TextureMapPtr read_texture_map(const Block& block, const ReadContext& context, bool average = false);
SlopeMapPtr read_slope_map(const Block& block, const ReadContext& context);

InteriorPtr read_interior(const Block& block, const ReadContext& context, const InteriorPtr& base);
std::shared_ptr<const Material> read_material(const Block& block, const ReadContext& context);
MediaPtr read_media(const Block& block, const ReadContext& context);
DensityPtr read_density(const Block& block, const ReadContext& context);
DensityMapPtr read_density_map(const Block& block, const ReadContext& context);

std::shared_ptr<const Transform> read_transform(const Block& block, const ReadContext& context);
/// Takes one transformation if it is next.
bool take_transformation(BlockReader& in, Transform& map);

ImageSource take_image(BlockReader& in);

void read_camera_draft(const Block& block, const ReadContext& context, CameraDraft& draft,
                       bool edits_default);
std::shared_ptr<const Camera> read_camera(const Block& block, const ReadContext& context);
std::shared_ptr<const Fog> read_fog(const Block& block, const ReadContext& context);
std::shared_ptr<const Rainbow> read_rainbow(const Block& block, const ReadContext& context);
std::shared_ptr<const SkySphere> read_sky_sphere(const Block& block, const ReadContext& context);
Color read_background(const Block& block, const ReadContext& context);
void read_global_settings(Session& session, const Block& block);
void read_global_photons(Session& session, const Block& block);
void read_light_photons(const Block& block, const ReadContext& context, LightPhotons& photons);
void read_object_photons(const Block& block, const ReadContext& context, ObjectPhotons& photons);
/// `radiosity { importance F }` of objects and of #default.
std::optional<double> read_importance(const Block& block, const ReadContext& context);

/// What a declared block is; error for a keyword that cannot stand there.
Value read_value(Session& session, const Block& block, const ReadContext& context);
FunctionPtr read_function_block(Session& session, const Block& block);
void read_default(Session& session, const Block& block);
/// Puts a top-level statement into the scene.
void read_statement(Session& session, const Block& block);

}  // namespace rb
