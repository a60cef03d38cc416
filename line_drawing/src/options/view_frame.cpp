// SPDX-License-Identifier: GPL-3.0-or-later
// Views as users write them: sides, angles, or vectors of a window's view; and sections.
#include "line_drawing/view_frame.h"

#include <Eigen/Geometry>
#include <cmath>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using Eigen::Vector3d;

const char* const kToward = "toward";
const char* const kFrom = "from";

Vector3d up_of(UpAxis axis) {
    return Vector3d::Unit(int(axis));
}

Vector3d front_of(UpAxis axis) {
    return axis == UpAxis::Z ? Vector3d(0, -1, 0) : Vector3d(0, 0, 1);
}

class ViewWords {
public:
    ViewWords(std::string_view text, UpAxis up, const NamedViews& others)
        : words_(words_of(text)), up_(up), others_(others) {}

    std::vector<ViewFrame> read() {
        std::vector<ViewFrame> views;
        while (next_ < words_.size()) {
            const std::string word = words_[next_++];
            if (lower(word) == "six")
                for (std::size_t side = 0; side < kSideNames.size(); ++side)
                    views.push_back(frame_of_side(Side(side), up_));
            else
                views.push_back(read_one(word));
        }
        if (views.empty()) refuse_word("");
        return views;
    }

private:
    ViewFrame read_one(const std::string& word) {
        const std::string name = lower(word);
        for (std::size_t side = 0; side < kSideNames.size(); ++side)
            if (name == lower(kSideNames[side])) return frame_of_side(Side(side), up_);
        if (name == "vessel") {
            ViewFrame frame = frame_of_side(Side::Front, up_);
            frame.name = "Vessel";
            frame.is_half_section = true;
            return frame;
        }
        if (name == kToward) return read_frame();
        for (const auto& [other, frame] : others_)
            if (name == lower(other)) return frame;
        const std::optional<double> azimuth = number_in(word);
        if (!azimuth || next_ == words_.size()) refuse_word(word);
        const std::optional<double> elevation = number_in(words_[next_++]);
        if (!elevation) refuse_word(words_[next_ - 1]);
        return frame_of_direction(*azimuth, *elevation, up_);
    }

    ViewFrame read_frame() {
        const Vector3d viewer = read_vector().stableNormalized(), up = read_vector();
        const Vector3d right = up.cross(viewer).stableNormalized();
        if (!(up.stableNormalized().cross(viewer).norm() > 1e-9)) refuse_word(kToward);  // parallel
        ViewFrame frame = frame_of_axes("View", viewer, viewer.cross(right));
        if (next_ == words_.size() || lower(words_[next_]) != kFrom) return frame;
        ++next_;
        frame.eye = read_vector();
        return frame;
    }

    Vector3d read_vector() {
        Vector3d vector;
        for (double& x : vector) {
            const std::optional<double> number =
                next_ < words_.size() ? number_in(words_[next_++]) : std::nullopt;
            if (!number) refuse_word(kToward);
            x = *number;
        }
        return vector;
    }

    [[noreturn]] static void refuse_word(const std::string& word) {
        refuse("\"" + word +
               "\" is not a view. Views are front, back, left, right, top, bottom, six (all of "
               "these), vessel, or azimuth and elevation in degrees, such as 30,15.");
    }

    const Words words_;
    const UpAxis up_;
    const NamedViews& others_;
    std::size_t next_ = 0;
};

constexpr std::string_view kAxes = "xyz";

Section section_from(const std::string& word) {
    const std::size_t axis = kAxes.find(lower(word)[0]);
    const double share =
        word.size() > 2 && word[1] == '=' ? number_in(word.substr(2)).value_or(0) : 0;
    if (axis == kAxes.npos || !(share > 0 && share < 1))
        refuse("\"" + word +
               "\" is not a section. A section is an axis and a place on it, 0 to 1 of the object, "
               "such as y=0.5.");
    return {int(axis), share};
}

}  // namespace

Vector3d in_mesh(const Vector3d& direction, const ViewFrame& frame) {
    return direction.x() * frame.right + direction.y() * frame.up +
           direction.z() * frame.towards_viewer;
}

ViewFrame frame_of_side(Side side, UpAxis axis) {
    const Vector3d up = up_of(axis), front = front_of(axis), right = up.cross(front);
    const Vector3d viewers[] = {front, -front, -right, right, up, -up},
                   upwards[] = {up, up, up, up, -front, front};
    const auto i = std::size_t(side);
    ViewFrame frame = frame_of_axes(kSideNames[i], viewers[i], upwards[i]);
    frame.side = side;
    return frame;
}

ViewFrame frame_of_direction(double azimuth, double elevation, UpAxis axis) {
    if (!(std::abs(elevation) <= 90) || !std::isfinite(azimuth))
        refuse(
            "A view's azimuth has to be a number of degrees, its elevation one between "
            "-90 and 90.");
    constexpr double degree = 0.017453292519943295;
    const Vector3d up = up_of(axis), front = front_of(axis), right = up.cross(front);
    const double a = azimuth * degree, e = elevation * degree;
    const Vector3d outwards = std::cos(a) * front + std::sin(a) * right;
    // Not beginning with a digit: SVG readers take that for a layer's number.
    const std::string name = "View " + in_digits(azimuth) + "°, " + in_digits(elevation) + "°";
    return frame_of_axes(name, std::cos(e) * outwards + std::sin(e) * up,
                         std::cos(e) * up - std::sin(e) * outwards);
}

ViewFrame frame_of_axes(const std::string& name, const Vector3d& towards_viewer, const Vector3d& up,
                        const std::optional<Vector3d>& eye) {
    return {Side::Other, name, up.cross(towards_viewer), up, towards_viewer, false, eye};
}

std::vector<Section> parse_sections(std::string_view text) {
    std::vector<Section> sections;
    for (const std::string& word : words_of(text))
        sections.push_back(section_from(word));
    return sections;
}

std::string letter_of(std::size_t number) {
    constexpr std::size_t letters = 26;
    const std::string last(1, char('A' + number % letters));
    return number < letters ? last : letter_of(number / letters - 1) + last;
}

ViewFrame frame_of_section(const Section& section, UpAxis up) {
    ViewFrame frame;
    for (const Side side : {Side::Top, Side::Front, Side::Left}) {
        frame = frame_of_side(side, up);
        if (frame.towards_viewer[section.axis] != 0) break;
    }
    frame.side = Side::Other;
    frame.name = std::string("Section ") + kAxes[std::size_t(section.axis)] + " = " +
                 in_digits(100 * section.share, 3) + " %";
    return frame;
}

std::string frame_text(const ViewFrame& frame) {
    constexpr int digits = 9;
    std::string words = kToward;
    const auto add = [&](const Vector3d& vector) {
        for (const double x : vector)
            words += ' ' + in_digits(x + 0., digits);  // no -0
    };
    add(frame.towards_viewer);
    add(frame.up);
    if (!frame.eye) return words;
    words += std::string(" ") + kFrom;
    add(*frame.eye);
    return words;
}

std::vector<ViewFrame> parse_views(std::string_view text, UpAxis up, const NamedViews& others) {
    return ViewWords(text, up, others).read();
}

}  // namespace line_drawing
