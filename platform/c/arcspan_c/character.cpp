// SPDX-License-Identifier: MIT
#include <arcspan/animate/attachment.hpp>
#include <arcspan/animate/posed_bound.hpp>

#include <arcspan_c/character.hpp>

using namespace arcspan;

namespace {

[[nodiscard]] uint16_t short_number(std::size_t number) {
  return number < ARCSPAN_NONE ? static_cast<uint16_t>(number) : ARCSPAN_NONE;
}

/// `origin` and an object length in the scale of an object, saturated.
[[nodiscard]] WorldLength sum(WorldLength origin, ObjectLength length, WorldLength scale) {
  constexpr int kDown = ObjectLength::kFraction + 15;  // a scale is the length of 2^15 object units
  const std::int64_t at = origin.raw() + ((std::int64_t{length.raw()} * scale.raw()) >> kDown);
  const std::int64_t most = at > INT32_MAX ? INT32_MAX : at;
  return WorldLength::from_raw(static_cast<std::int32_t>(most < INT32_MIN ? INT32_MIN : most));
}

/// The body of a character, whose parts are at one place.
[[nodiscard]] const Object& body_of(const arcspan_character& character) {
  return *character.scene.parts_of(character.object).data();
}

/// A node's axes in the world; its offset from the body in object units.
[[nodiscard]] Placement turned_node(const arcspan_character& character, uint16_t node) {
  return attached({body_of(character).rotation, {}}, character.nodes[node]);
}

[[nodiscard]] WorldPoint node_position(const arcspan_character& character, const Placement& place) {
  const Object& body = body_of(character);
  return {sum(body.position.x, place.translation[0], body.scale),
          sum(body.position.y, place.translation[1], body.scale),
          sum(body.position.z, place.translation[2], body.scale)};
}

}  // namespace

std::span<JointMatrix> arcspan_character::joints_of(std::size_t skin) const {
  std::size_t first = 0;
  for (std::size_t i = 0; i < skin; ++i) first += animation.skin(i).size();
  return joints.subspan(first, animation.skin(skin).size());
}

std::span<std::int16_t> arcspan_character::weights_of(std::size_t part) const {
  std::size_t first = 0;
  for (std::size_t i = 0; i < part; ++i) first += animation.morph(i).target_count();
  return weights.subspan(first, animation.morph(part).target_count());
}

void arcspan_character::pose() {
  // Each has the memory that it asks for.
  const ClipBlend blend = player.blend();
  (void)pose_nodes(animation, blend, nodes);
  for (std::size_t i = 0; i < animation.skin_count(); ++i)
    (void)pose_joints(animation.skin(i), nodes, joints_of(i));
  const std::span<Object> parts = scene.parts_of(object);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const StoredWeights follows = animation.weights(i);
    const bool is_morphed = animation.morph(i).target_count() != 0;
    if (is_morphed) (void)pose_morph(animation, i, blend, weights_of(i));
    if (follows.exist()) {
      parts[i].set_sphere(posed_bound(animation.bounds(i), joints_of(follows.skin())));
    } else if (is_morphed) {
      parts[i].set_sphere(posed_bound({}, {}));  // unknown
    }
  }
}

arcspan_object arcspan_object_of(const arcspan_character* character) { return character->object; }

uint16_t arcspan_clip_count(const arcspan_character* character) {
  return short_number(character->animation.clip_count());
}

uint16_t arcspan_find_clip(const arcspan_character* character, const char* name) {
  return name != nullptr ? short_number(character->animation.find_clip(name)) : ARCSPAN_NONE;
}

const char* arcspan_clip_name(const arcspan_character* character, uint16_t clip) {
  return clip < character->animation.clip_count() ? character->animation.clip(clip).name() : "";
}

uint32_t arcspan_clip_length(const arcspan_character* character, uint16_t clip) {
  return clip < character->animation.clip_count() ? character->animation.clip(clip).duration() : 0;
}

arcspan_status arcspan_play(arcspan_character* character, uint16_t clip, uint32_t fade,
                            arcspan_at_end at_end) {
  if (clip >= character->animation.clip_count() || at_end > ARCSPAN_REPEAT) return ARCSPAN_INVALID_ARGUMENT;
  character->player.fade_to(character->animation.clip(clip), fade,
                            at_end == ARCSPAN_REPEAT ? AtClipEnd::kRepeat : AtClipEnd::kStop);
  return ARCSPAN_OK;
}

void arcspan_set_speed(arcspan_character* character, int32_t speed) {
  character->player.set_speed(ClipSpeed::from_raw(speed));
}

void arcspan_seek(arcspan_character* character, uint32_t time) { character->player.seek(time); }

uint32_t arcspan_clip_time(const arcspan_character* character) { return character->player.time(); }

int arcspan_has_ended(const arcspan_character* character) { return character->player.has_ended() ? 1 : 0; }

void arcspan_advance(arcspan_character* character, uint32_t microseconds) {
  character->player.advance(microseconds);
  character->pose();
}

uint16_t arcspan_find_node(const arcspan_character* character, const char* name) {
  return name != nullptr ? short_number(character->animation.find_node(name)) : ARCSPAN_NONE;
}

arcspan_status arcspan_node_position(const arcspan_character* character, uint16_t node,
                                     arcspan_point* position) {
  if (node >= character->nodes.size()) return ARCSPAN_INVALID_ARGUMENT;
  const Placement place = turned_node(*character, node);
  const WorldPoint at = node_position(*character, place);
  *position = {at.x.raw(), at.y.raw(), at.z.raw()};
  return ARCSPAN_OK;
}

arcspan_status arcspan_attach(const arcspan_character* character, uint16_t node, arcspan_object object) {
  const std::span<Object> held = character->scene.parts_of(object);
  if (node >= character->nodes.size() || held.empty() || object == character->object)
    return ARCSPAN_INVALID_ARGUMENT;
  const Placement place = turned_node(*character, node);
  for (Object& part : held) {
    part.rotation = place.rotation;
    part.position = node_position(*character, place);
  }
  return ARCSPAN_OK;
}
