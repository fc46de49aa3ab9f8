#include <charconv>

#include "scene/json_text.h"

namespace tyndall {
namespace {

using Kind = JsonValue::Kind;

void append_utf8(std::string& out, uint32_t code) {
    const auto put = [&](uint32_t byte) { out += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0u | code >> 6u);
        put(0x80u | (code & 0x3fu));
    } else if (code < 0x10000) {
        put(0xe0u | code >> 12u);
        put(0x80u | (code >> 6u & 0x3fu));
        put(0x80u | (code & 0x3fu));
    } else {
        put(0xf0u | code >> 18u);
        put(0x80u | (code >> 12u & 0x3fu));
        put(0x80u | (code >> 6u & 0x3fu));
        put(0x80u | (code & 0x3fu));
    }
}

/// Bytes of the well-formed UTF-8 character at `at`, 0 when there is none (Unicode 15, table 3-7).
size_t utf8_length(std::string_view text, size_t at) {
    const auto byte = [&](size_t i) -> unsigned {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const auto tail = [&](size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first <= 0xdf) return tail(1) ? 2 : 0;
    if (first >= 0xe0 && first <= 0xef) {
        const bool shortest = first != 0xe0 || byte(1) >= 0xa0;
        const bool no_surrogate = first != 0xed || byte(1) < 0xa0;
        return shortest && no_surrogate && tail(1) && tail(2) ? 3 : 0;
    }
    if (first >= 0xf0 && first <= 0xf4) {
        const bool in_range = (first != 0xf0 || byte(1) >= 0x90) && (first != 0xf4 || byte(1) < 0x90);
        return in_range && tail(1) && tail(2) && tail(3) ? 4 : 0;
    }
    return 0;
}

class Parser {
 public:
    explicit Parser(JsonDocument& document) : document_(document), text_(document.text) {}

    void run() {
        if (text_.size() > kMaxJsonBytes) fail(0, "file is larger than 64 MiB", {});
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
        parse_value(document_.root, 0);
        skip_space();
        if (at_ < text_.size()) fail(at_, "text after the end of the JSON value", "the end of the file");
    }

 private:
    [[noreturn]] void fail(size_t at, std::string message, std::string expected) const {
        throw Error(Diagnostic{document_.locate(at), std::move(message), std::move(expected), {}});
    }
    [[noreturn]] void unexpected(std::string expected) const {
        if (at_ >= text_.size()) fail(at_, "unexpected end of the file", std::move(expected));
        if (text_[at_] == '/' || text_[at_] == '#') fail(at_, "JSON has no comments", std::move(expected));
        const size_t length = utf8_length(text_, at_);
        const bool printable = length > 1 || (text_[at_] >= 0x20 && text_[at_] < 0x7f);
        const std::string what = printable && length > 0
                                     ? "'" + std::string(text_.substr(at_, length)) + "'"
                                     : "byte " + std::to_string(static_cast<unsigned char>(text_[at_]));
        fail(at_, "unexpected " + what, std::move(expected));
    }

    [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void skip_space() {
        while (at_ < text_.size() &&
               (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t' || text_[at_] == '\r'))
            ++at_;
    }

    void parse_value(JsonValue& value, size_t depth) {
        skip_space();
        if (++count_ > kMaxJsonValues) fail(at_, "file has more than 2 million values", {});
        value.begin = at_;
        switch (peek()) {
            case '{':
                parse_object(value, depth + 1);
                break;
            case '[':
                parse_array(value, depth + 1);
                break;
            case '"':
                value.kind = Kind::string;
                value.string = parse_string();
                break;
            case 't':
            case 'f':
            case 'n':
                parse_word(value);
                break;
            default:
                parse_number(value);
        }
        value.end = at_;
    }

    void check_depth(size_t depth) const {
        if (depth > kMaxJsonDepth) fail(at_, "more than 64 levels of nesting", {});
    }

    void parse_object(JsonValue& value, size_t depth) {
        check_depth(depth);
        value.kind = Kind::object;
        ++at_;
        skip_space();
        if (take('}')) return;
        while (true) {
            skip_space();
            if (peek() != '"')
                unexpected(value.members.empty() ? "a quoted key or '}'" : "a quoted key: no comma before '}'");
            JsonMember& member = value.members.emplace_back();
            member.key_begin = at_;
            member.key = parse_string();
            skip_space();
            if (!take(':')) unexpected("':' after the key");
            parse_value(member.value, depth);
            skip_space();
            if (take('}')) return;
            if (!take(',')) unexpected("',' or '}'");
        }
    }

    void parse_array(JsonValue& value, size_t depth) {
        check_depth(depth);
        value.kind = Kind::array;
        ++at_;
        skip_space();
        if (take(']')) return;
        while (true) {
            skip_space();
            if (peek() == ']') unexpected("a value: no comma before ']'");
            parse_value(value.items.emplace_back(), depth);
            skip_space();
            if (take(']')) return;
            if (!take(',')) unexpected("',' or ']'");
        }
    }

    void parse_word(JsonValue& value) {
        const auto word = [&](std::string_view name) {
            if (text_.substr(at_, name.size()) != name) return false;
            at_ += name.size();
            return true;
        };
        if (word("true")) {
            value.kind = Kind::boolean;
            value.boolean = true;
        } else if (word("false")) {
            value.kind = Kind::boolean;
        } else if (!word("null")) {
            unexpected("a value: true, false, null, a number, a string, an array or an object");
        }
    }

    bool digits() {
        const size_t start = at_;
        while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
        return at_ > start;
    }

    void parse_number(JsonValue& value) {
        if (peek() != '-' && (peek() < '0' || peek() > '9'))
            unexpected(peek() == 'N' || peek() == 'I' || peek() == '+' || peek() == '.'
                           ? "a finite decimal number such as 0.5"
                           : "a value");
        take('-');
        const size_t first = at_;
        if (!digits()) unexpected("a digit");
        if (text_[first] == '0' && at_ > first + 1) fail(first, "number with a leading zero", {});
        if (take('.') && !digits()) unexpected("a digit after the decimal point");
        if (take('e') || take('E')) {
            if (!take('+')) take('-');
            if (!digits()) unexpected("a digit of the exponent");
        }
        value.kind = Kind::number;
        const auto [end, failed] = std::from_chars(text_.data() + value.begin, text_.data() + at_, value.number);
        // Out of range is too large, or so small that it is zero; digits and exponent tell which.
        if (failed == std::errc::result_out_of_range && !underflows(text_.substr(value.begin, at_ - value.begin)))
            fail(value.begin, "number is too large to be finite", "a finite number");
    }

    static bool underflows(std::string_view number) {
        const size_t exponent = number.find_first_of("eE");
        if (exponent != std::string_view::npos) return number[exponent + 1] == '-';
        return number.starts_with("0.") || number.starts_with("-0.");
    }

    uint32_t parse_hex() {
        uint32_t code = 0;
        for (int i = 0; i < 4; ++i, ++at_) {
            const char c = peek();
            const bool digit = c >= '0' && c <= '9';
            const bool lower = c >= 'a' && c <= 'f';
            const bool upper = c >= 'A' && c <= 'F';
            if (!digit && !lower && !upper) unexpected("four hexadecimal digits after \\u");
            code = code * 16u + static_cast<uint32_t>(digit ? c - '0' : lower ? c - 'a' + 10 : c - 'A' + 10);
        }
        return code;
    }

    void parse_unicode_escape(std::string& out) {
        const size_t start = at_ - 2;
        uint32_t code = parse_hex();
        if (code >= 0xd800 && code < 0xdc00) {
            if (!take('\\') || !take('u')) fail(start, "half a surrogate pair", "\\u and the other half after it");
            const uint32_t low = parse_hex();
            if (low < 0xdc00 || low >= 0xe000) fail(start, "half a surrogate pair", "\\udc00 to \\udfff after it");
            code = 0x10000u + ((code - 0xd800u) << 10u) + (low - 0xdc00u);
        } else if (code >= 0xdc00 && code < 0xe000) {
            fail(start, "half a surrogate pair", {});
        }
        append_utf8(out, code);
    }

    void parse_escape(std::string& out) {
        static constexpr std::string_view kNames = "\"\\/bfnrt";
        static constexpr std::string_view kValues = "\"\\/\b\f\n\r\t";
        const size_t known = peek() == '\0' ? std::string_view::npos : kNames.find(peek());
        if (known != std::string_view::npos) {
            out += kValues[known];
            ++at_;
        } else if (take('u')) {
            parse_unicode_escape(out);
        } else {
            unexpected("one of \" \\ / b f n r t u after the backslash");
        }
    }

    std::string parse_string() {
        const size_t start = at_++;
        std::string out;
        while (true) {
            if (at_ >= text_.size()) fail(start, "string without its closing quote", {});
            const auto c = static_cast<unsigned char>(text_[at_]);
            if (c == '"') break;
            if (c == '\n') fail(start, "string without its closing quote on this line", {});
            if (c < 0x20) fail(at_, "control character in a string", "an escape such as \\t");
            if (c == '\\') {
                ++at_;
                parse_escape(out);
                continue;
            }
            const size_t length = utf8_length(text_, at_);
            if (length == 0) fail(at_, "text is not UTF-8", {});
            out += text_.substr(at_, length);
            at_ += length;
        }
        ++at_;
        return out;
    }

    JsonDocument& document_;
    std::string_view text_;
    size_t at_ = 0;
    size_t count_ = 0;
};

}  // namespace

JsonDocument parse_json(std::string text, std::string file) {
    JsonDocument document{std::move(file), std::move(text), {}};
    Parser(document).run();
    return document;
}

}  // namespace tyndall
