// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/scene/posed_material.hpp>

#include <arcspan_c/character_mesh.hpp>
#include <arcspan_c/compiled_methods.hpp>

#include <new>

namespace arcspan::c {

using CharacterMaterial = PosedMaterial<CharacterMesh>;

/// Makes at `at` the posed material of a mesh from a prepared one, which is of a compiled method.
template <class... Chosen>
void make_posed(ChoiceList<Chosen...>, const SceneMaterial& material, const CharacterMesh& mesh,
                CharacterMaterial* at) {
  const auto make = [&]<class Method>() {
    if (material.use() != &arcspan::detail::kUseFacts<typename arcspan::detail::UseOf<Method>::Type>)
      return false;
    new (at) CharacterMaterial(static_cast<const PreparedMaterial<Method>&>(material), mesh);
    return true;
  };
  (void)(make.template operator()<typename Chosen::Method>() || ...);
}

}  // namespace arcspan::c
