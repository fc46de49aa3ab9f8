#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "scene/field_reader.h"
#include "scene/field_writer.h"
#include "scene/json_text.h"
#include "scene_test_types.h"

namespace tyndall {
namespace {

std::string error_of(std::string text) {
    try {
        (void)parse_json(std::move(text), "f.json");
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

void expect_same(const JsonDocument& document, const JsonValue& ours, const nlohmann::json& theirs) {
    // Every value's span is that value: parsed alone it is the same again.
    EXPECT_EQ(nlohmann::json::parse(document.raw(ours)), theirs);
    EXPECT_EQ(ours.is(JsonValue::Kind::object), theirs.is_object());
    EXPECT_EQ(ours.is(JsonValue::Kind::array), theirs.is_array());
    if (theirs.is_string()) {
        EXPECT_EQ(ours.string, theirs.get<std::string>());
    }
    if (theirs.is_number()) {
        EXPECT_EQ(ours.number, theirs.get<double>());
    }
    if (theirs.is_array())
        for (size_t i = 0; i < theirs.size(); ++i) expect_same(document, ours.items.at(i), theirs[i]);
    if (theirs.is_object())
        for (const JsonMember& member : ours.members) {
            EXPECT_EQ(document.text[member.key_begin], '"');
            expect_same(document, member.value, theirs.at(member.key));
        }
}

TEST(JsonText, ReadsWhatNlohmannReads) {
    for (const std::string& text : {std::string(scene_test::kSample), std::string(" [] "), std::string("{}"),
                                    std::string("-0.0e-3"), std::string("[1, -2.5, 1e5, true, false, null]"),
                                    std::string(R"(["\"\\\/\b\f\n\r\t\u0041\u00e9\u20ac\ud83d\ude00", "é€😀"])"),
                                    std::string("\xef\xbb\xbf{\"a\": 1}"), std::string("1e-400")}) {
        const JsonDocument document = parse_json(text, "f.json");
        expect_same(document, document.root, nlohmann::json::parse(text));
    }
}

TEST(JsonText, AcceptsExactlyWhatNlohmannAccepts) {
    std::mt19937 random(7);
    const std::string letters = "{}[]\",:0123456789.eE+-tfnul\\ /\n\t\x01\xc3\xa9\xff";
    size_t accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        // A short piece, so that a change often leaves something valid.
        std::string text = R"({"a": [1, -2.5e3, true, null], "b": {"c": "x\u00e9"}, "d": ""})";
        for (size_t change = 0; change < 1 + random() % 3; ++change)
            text[random() % text.size()] = letters[random() % letters.size()];
        const bool theirs = nlohmann::json::accept(text);
        EXPECT_EQ(error_of(text).empty(), theirs) << text << "\n" << error_of(text);
        accepted += theirs ? 1 : 0;
    }
    EXPECT_GT(accepted, 100u);
}

TEST(JsonText, ErrorsSayWhereAndWhat) {
    EXPECT_EQ(error_of("{\n  \"a\": 1,\n  // no\n}"),
              "f.json:3:3: JSON has no comments (expected a quoted key: no comma before '}')");
    EXPECT_EQ(error_of("{\"a\": 1,}"), "f.json:1:9: unexpected '}' (expected a quoted key: no comma before '}')");
    EXPECT_EQ(error_of("[1 2]"), "f.json:1:4: unexpected '2' (expected ',' or ']')");
    EXPECT_EQ(error_of("{\"a\": NaN}"), "f.json:1:7: unexpected 'N' (expected a finite decimal number such as 0.5)");
    EXPECT_EQ(error_of("[\"é\", x]"), "f.json:1:7: unexpected 'x' (expected a value)");
    EXPECT_EQ(error_of("[1e999]"), "f.json:1:2: number is too large to be finite (expected a finite number)");
    EXPECT_EQ(error_of("[\"abc\n\"]"), "f.json:1:2: string without its closing quote on this line");
    EXPECT_EQ(error_of(""), "f.json:1:1: unexpected end of the file (expected a value)");
    EXPECT_EQ(error_of("{} {}"), "f.json:1:4: text after the end of the JSON value (expected the end of the file)");
    EXPECT_NE(error_of("[\"\xff\"]").find("not UTF-8"), std::string::npos);
    EXPECT_NE(error_of("[\"\\ud800\"]").find("surrogate"), std::string::npos);
}

TEST(JsonText, DepthAndSizeAreBounded) {
    EXPECT_EQ(error_of(std::string(64, '[') + std::string(64, ']')), "");
    EXPECT_NE(error_of(std::string(65, '[') + std::string(65, ']')).find("64 levels"), std::string::npos);
    EXPECT_NE(error_of(std::string(10'000'000, '[')).find("64 levels"), std::string::npos);
    EXPECT_NE(error_of(std::string(kMaxJsonBytes + 1, ' ')).find("64 MiB"), std::string::npos);
    std::string many = "[0";
    for (size_t i = 0; i < kMaxJsonValues; ++i) many += ",0";
    EXPECT_NE(error_of(many + "]").find("2 million values"), std::string::npos);
}

TEST(JsonText, FloatsRoundTripShortest) {
    EXPECT_EQ(json_number(0.1f), "0.1");
    EXPECT_EQ(json_number(48000.0f), "48000");
    EXPECT_EQ(json_number(100000.0f), "100000");
    EXPECT_EQ(json_number(-1e-7f), "-1e-07");
    EXPECT_EQ(json_number(std::nanf("")), "0");
    EXPECT_EQ(json_number(std::numeric_limits<float>::infinity()), "3.4028235e+38");
    const Field field;
    std::mt19937 random(3);
    for (int i = 0; i < 100000; ++i) {
        const auto bits = static_cast<uint32_t>(random());
        float value;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        const JsonDocument document = parse_json(json_number(value), "f");
        std::vector<Diagnostic> list;
        Problems problems(document, list);
        float back = 0.0f;
        ASSERT_TRUE(read_real(field, back, document.root, problems)) << json_number(value);
        ASSERT_EQ(std::memcmp(&back, &value, sizeof value), 0) << json_number(value);
    }
}

TEST(JsonText, LongValuesAreWrapped) {
    const std::string list = "{ \"a\": [" + std::string(60, '1') + ", " + std::string(60, '2') + "], \"b\": 1 }";
    EXPECT_EQ(wrap_json(list, 4, 4), "{\n      \"a\": [\n        " + std::string(60, '1') + ",\n        " +
                                         std::string(60, '2') + "\n      ],\n      \"b\": 1\n    }");
    EXPECT_EQ(wrap_json("{ \"a\": 1 }", 4, 4), "{ \"a\": 1 }");
}

}  // namespace
}  // namespace tyndall
