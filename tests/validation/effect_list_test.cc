#include "validation/effect_list.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim/effects/catalogue.h"

namespace nao::validation {
namespace {

TEST(EffectList, NamesEveryEffectAndParameterInBothForms) {
  const nlohmann::json all = nlohmann::json::parse(listEffectsAsJson());
  const std::string text = listEffectsAsText();
  EXPECT_EQ(all.size(), sim::standardEffects().types().size());
  for (const sim::EffectType& type : sim::standardEffects().types()) {
    EXPECT_NE(text.find(type.summary), std::string::npos) << type.name;
    ASSERT_EQ(all.at(type.name).at("parameters").size(), type.parameters.size()) << type.name;
    for (std::size_t i = 0; i < type.parameters.size(); ++i) {
      const auto& listed = all.at(type.name).at("parameters").at(i);
      EXPECT_EQ(listed.at("name"), type.parameters[i].name);
      EXPECT_EQ(listed.at("max"), type.parameters[i].max);
      EXPECT_EQ(listed.at("unit"), type.parameters[i].unit);
    }
  }
}

}  // namespace
}  // namespace nao::validation
