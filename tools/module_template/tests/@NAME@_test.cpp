#include <gtest/gtest.h>

#include "../@NAME@_component.h"

namespace tyndall::@NAME@ {
namespace {

TEST(@Name@, EveryFieldHasAUnitAndARange) {
    const auto type = describe_struct<@Name@Component>("@NAME@");
    ASSERT_EQ(type->fields.size(), 2u);
    for (const Field& field : type->fields) {
        EXPECT_FALSE(field.unit.empty()) << field.name;
        EXPECT_GE(field.minimum, 0.0) << field.name;
    }
}

}  // namespace
}  // namespace tyndall::@NAME@
