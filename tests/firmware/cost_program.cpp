// SPDX-License-Identifier: MIT
// What one method costs: draws as a product does and prints the names of its sections for
// instruction_count.py. The program has one method, one illumination, one sink and one depth buffer, for
// which CMakeLists.txt defines macros. If the emulator has loaded jobs or random scenes, it draws these;
// otherwise, in the light of the benchmark frame, the measured scenes, and in other light that frame.
#ifdef ARCSPAN_LIGHTS
#include <tests/firmware/cost_light.hpp>
#else
#include <tests/firmware/cost_scenes.hpp>
#endif
#ifdef ARCSPAN_COST_MORE
#include <tests/firmware/cost_bands.hpp>
#include <tests/firmware/cost_character.hpp>
#endif
#ifndef ARCSPAN_COST_OWN_SINK
#include <tests/firmware/cost_jobs.hpp>
#include <tests/firmware/cost_random_scenes.hpp>
#endif

namespace {

bool draw() {
  using namespace arcspan;
#ifndef ARCSPAN_COST_OWN_SINK
  if (cost_jobs_loaded()) return draw_cost_jobs();
  if (random_scenes_loaded()) return draw_random_scenes();
#endif
#if defined(ARCSPAN_LIGHTS)
  return draw_in_cost_light();
#elif defined(ARCSPAN_COST_MORE)
  return for_each_cost_scene(draw_cost_scene) && draw_in_cost_bands() && draw_cost_character();
#else
  return for_each_cost_scene(draw_cost_scene);
#endif
}

}  // namespace

int main() { return draw() ? 0 : 1; }
