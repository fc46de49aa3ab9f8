#include "scene/phase_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include "core/error.h"
#include "core/paths.h"
#include "scene/render_scene.h"

namespace tyndall {
namespace {

constexpr size_t kMostRows = 100'000;
constexpr size_t kMostValues = 18'001;  // a hundredth of a degree

struct Row {
    double angle = 0.0;
    glm::dvec3 value{0.0};
};

/// Rows of a text, with complaints about its lines.
class Reader {
 public:
    explicit Reader(const std::filesystem::path& file) : file_(file.string()), text_(paths::read_file(file)) {}

    std::vector<Row> rows() {
        std::vector<Row> rows;
        for (std::string_view rest = text_; !rest.empty();) {
            const size_t end = rest.find('\n');
            ++line_;
            add(rest.substr(0, end), rows);
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        }
        if (rows.size() < 2 || rows.back().angle != 180.0) fail("the table ends too early", "angles up to 180 degrees");
        return rows;
    }

    [[noreturn]] void fail(std::string message, std::string expected) const {
        throw Error(Diagnostic{{file_, line_}, std::move(message), std::move(expected), {}});
    }

 private:
    void add(std::string_view line, std::vector<Row>& rows) {
        const std::vector<double> numbers = numbers_of(line.substr(0, line.find('#')));
        if (numbers.empty()) return;
        if (numbers.size() != 2 && numbers.size() != 4)
            fail(fmt::format("{} numbers in a line", numbers.size()),
                 "an angle and one value, or one for each channel");
        if (rows.empty() && numbers[0] != 0.0) fail("the first angle is not 0", "angles from 0 to 180 degrees");
        if (!rows.empty() && numbers[0] <= rows.back().angle) fail("the angles do not rise", "rising angles");
        if (numbers[0] > 180.0) fail("an angle above 180 degrees", "angles from 0 to 180 degrees");
        if (rows.size() == kMostRows) fail("too many rows", fmt::format("at most {}", kMostRows));
        const bool grey = numbers.size() == 2;
        rows.push_back({numbers[0], {numbers[1], numbers[grey ? 1 : 2], numbers[grey ? 1 : 3]}});
        for (int i = 0; i < 3; ++i)
            if (!(rows.back().value[i] >= 0.0 && rows.back().value[i] < 1e30))
                fail("a value out of range", "0 or more");
    }

    std::vector<double> numbers_of(std::string_view line) const {
        constexpr std::string_view kBetween = " \t\r,;";
        std::vector<double> numbers;
        for (size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;
             at = line.find_first_not_of(kBetween, at)) {
            const std::string_view word = line.substr(at, line.find_first_of(kBetween, at) - at);
            double number = 0.0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
            if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(number))
                fail("'" + std::string(word.substr(0, 40)) + "' is no number", "numbers, and comments after #");
            numbers.push_back(number);
            at += word.size();
        }
        return numbers;
    }

    std::string file_;
    std::string text_;
    int line_ = 0;
};

/// Evenly spaced values through the rows, as fine as the rows are where they are finest.
std::vector<glm::vec3> resampled(const std::vector<Row>& rows) {
    double finest = 180.0;
    for (size_t i = 1; i < rows.size(); ++i) finest = std::min(finest, rows[i].angle - rows[i - 1].angle);
    const double steps = std::ceil(180.0 / finest - 1e-6);
    const size_t count = std::min(static_cast<size_t>(std::min(steps, 1e9)) + 1, kMostValues);
    std::vector<glm::vec3> values;
    size_t row = 1;
    for (size_t i = 0; i < count; ++i) {
        const double angle = 180.0 * static_cast<double>(i) / static_cast<double>(count - 1);
        while (row + 1 < rows.size() && rows[row].angle < angle) ++row;
        const Row& a = rows[row - 1];
        const Row& b = rows[row];
        values.emplace_back(glm::mix(a.value, b.value, glm::clamp((angle - a.angle) / (b.angle - a.angle), 0.0, 1.0)));
    }
    return values;
}

/// Integral over the sphere of a function that is linear in the angle between evenly spaced values.
glm::dvec3 sphere_integral(const std::vector<glm::vec3>& values) {
    const double step = glm::pi<double>() / static_cast<double>(values.size() - 1);
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i + 1 < values.size(); ++i) {
        const double from = step * static_cast<double>(i), to = from + step;
        const glm::dvec3 a(values[i]), b(values[i + 1]);
        sum += a * std::cos(from) - b * std::cos(to) + (b - a) / step * (std::sin(to) - std::sin(from));
    }
    return glm::two_pi<double>() * sum;
}

}  // namespace

bool normalise(PhaseTable& table) {
    const glm::dvec3 integral = sphere_integral(table.values);
    if (!(integral.x > 0.0 && integral.y > 0.0 && integral.z > 0.0)) return false;
    for (glm::vec3& value : table.values) value = glm::vec3(glm::dvec3(value) / integral);
    return true;
}

PhaseTable load_phase_table(const std::filesystem::path& file, std::string_view name) {
    Reader reader(file);
    std::vector<Row> rows = reader.rows();
    glm::dvec3 greatest(0.0);
    for (const Row& row : rows) greatest = glm::max(greatest, row.value);
    for (Row& row : rows) row.value /= glm::max(greatest, glm::dvec3(1e-300));  // floats hold it, whatever the scale
    PhaseTable table{.id = new_asset_id(), .name = std::string(name), .values = resampled(rows)};
    if (!normalise(table)) reader.fail("a channel scatters nothing", "values above 0");
    return table;
}

}  // namespace tyndall
