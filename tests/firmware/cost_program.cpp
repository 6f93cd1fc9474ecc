// SPDX-License-Identifier: MIT
// Draws frames by one method, as a product does, for instruction_count.py, which counts the instructions of
// each; "section:" lines name them. The program has one method, one illumination, one sink and one depth
// buffer (cost_method.hpp). If the emulator has loaded jobs, these are drawn. Otherwise the measured scenes
// are, by a program with the benchmark frame's illumination, or that frame, by one with another.
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
#endif

namespace {

bool draw() {
  using namespace arcspan;
#ifndef ARCSPAN_COST_OWN_SINK
  if (cost_jobs_loaded()) return draw_cost_jobs(draw_cost_job);
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
