// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/view_frame.h"

#include <Eigen/Geometry>
#include <cmath>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using Eigen::Vector3d;

const char* const toward = "toward";
const char* const from = "from";
constexpr std::array<const char*, 6> side_names = {"Front", "Back", "Left",
                                                   "Right", "Top",  "Bottom"};

Vector3d upOf(UpAxis axis) {
    return Vector3d::Unit(int(axis));
}

Vector3d frontOf(UpAxis axis) {
    return axis == UpAxis::Z ? Vector3d(0, -1, 0) : Vector3d(0, 0, 1);
}

ViewFrame makeFrame(Side side, const std::string& name, const Vector3d& towards_viewer,
                    const Vector3d& up) {
    return {side, name, up.cross(towards_viewer), up, towards_viewer, false};
}

/// A half section from the front.
ViewFrame frameOfVessel(UpAxis axis) {
    ViewFrame frame = frameOfSide(Side::Front, axis);
    frame.name = "Vessel";
    frame.is_half_section = true;
    return frame;
}

class ViewWords {
public:
    ViewWords(std::string_view text, UpAxis up, const NamedViews& others)
        : words_(wordsOf(text)), up_(up), others_(others) {}

    std::vector<ViewFrame> read() {
        std::vector<ViewFrame> views;
        while (next_ < words_.size()) {
            const std::string word = words_[next_++];
            if (lower(word) == "six")
                for (std::size_t side = 0; side < side_names.size(); ++side)
                    views.push_back(frameOfSide(Side(side), up_));
            else
                views.push_back(readOne(word));
        }
        if (views.empty()) refuseWord("");
        return views;
    }

private:
    ViewFrame readOne(const std::string& word) {
        const std::string name = lower(word);
        for (std::size_t side = 0; side < side_names.size(); ++side)
            if (name == lower(side_names[side])) return frameOfSide(Side(side), up_);
        if (name == "vessel") return frameOfVessel(up_);
        if (name == toward) return readFrame();
        for (const auto& [other, frame] : others_)
            if (name == lower(other)) return frame;
        const std::optional<double> azimuth = numberIn(word);
        if (!azimuth || next_ == words_.size()) refuseWord(word);
        const std::optional<double> elevation = numberIn(words_[next_++]);
        if (!elevation) refuseWord(words_[next_ - 1]);
        return frameOfDirection(*azimuth, *elevation, up_);
    }

    ViewFrame readFrame() {
        const Vector3d viewer = readVector().stableNormalized(), up = readVector();
        const Vector3d right = up.cross(viewer).stableNormalized();
        if (!(viewer.allFinite() && right.norm() > 0.5)) refuseWord(toward);
        ViewFrame frame = makeFrame(Side::Other, "View", viewer, viewer.cross(right));
        if (next_ == words_.size() || lower(words_[next_]) != from) return frame;
        ++next_;
        frame.eye = readVector();
        return frame;
    }

    Vector3d readVector() {
        Vector3d vector;
        for (double& x : vector) {
            const std::optional<double> number =
                next_ < words_.size() ? numberIn(words_[next_++]) : std::nullopt;
            if (!number) refuseWord(toward);
            x = *number;
        }
        return vector;
    }

    [[noreturn]] static void refuseWord(const std::string& word) {
        refuse("\"" + word +
               "\" is not a view. Views are front, back, left, right, top, bottom, six (all of "
               "these), vessel, or azimuth and elevation in degrees, such as 30,15.");
    }

    const Words words_;
    const UpAxis up_;
    const NamedViews& others_;
    std::size_t next_ = 0;
};

constexpr std::string_view axes = "xyz";

Section sectionFrom(const std::string& word) {
    const std::size_t axis = axes.find(lower(word)[0]);
    const double share =
        word.size() > 2 && word[1] == '=' ? numberIn(word.substr(2)).value_or(0) : 0;
    if (axis == axes.npos || !(share > 0 && share < 1))
        refuse("\"" + word +
               "\" is not a section. A section is an axis and a place on it, 0 to 1 of the object, "
               "such as y=0.5.");
    return {int(axis), share};
}

}  // namespace

std::array<const char*, 6> sideNames() {
    return side_names;
}

Vector3d inMesh(const Vector3d& direction, const ViewFrame& frame) {
    return direction.x() * frame.right + direction.y() * frame.up +
           direction.z() * frame.towards_viewer;
}

ViewFrame frameOfSide(Side side, UpAxis axis) {
    const Vector3d up = upOf(axis), front = frontOf(axis), right = up.cross(front);
    const std::string name = side_names[std::size_t(side)];
    switch (side) {
        case Side::Back:
            return makeFrame(side, name, -front, up);
        case Side::Left:
            return makeFrame(side, name, -right, up);
        case Side::Right:
            return makeFrame(side, name, right, up);
        case Side::Top:
            return makeFrame(side, name, up, -front);
        case Side::Bottom:
            return makeFrame(side, name, -up, front);
        default:
            return makeFrame(side, name, front, up);
    }
}

ViewFrame frameOfDirection(double azimuth, double elevation, UpAxis axis) {
    if (!(std::abs(elevation) <= 90) || !std::isfinite(azimuth))
        refuse(
            "A view's azimuth has to be a number of degrees, its elevation one between "
            "-90 and 90.");
    constexpr double degree = 0.017453292519943295;
    const Vector3d up = upOf(axis), front = frontOf(axis), right = up.cross(front);
    const double a = azimuth * degree, e = elevation * degree;
    const Vector3d outwards = std::cos(a) * front + std::sin(a) * right;
    // No digit first: readers of SVG take that for a layer's number.
    const std::string name = "View " + inDigits(azimuth) + "°, " + inDigits(elevation) + "°";
    return makeFrame(Side::Other, name, std::cos(e) * outwards + std::sin(e) * up,
                     std::cos(e) * up - std::sin(e) * outwards);
}

std::vector<Section> parseSections(std::string_view text) {
    std::vector<Section> sections;
    for (const std::string& word : wordsOf(text))
        sections.push_back(sectionFrom(word));
    return sections;
}

std::string letterOf(std::size_t number) {
    constexpr std::size_t letters = 26;
    const std::string last(1, char('A' + number % letters));
    return number < letters ? last : letterOf(number / letters - 1) + last;
}

ViewFrame frameOfSection(const Section& section, UpAxis up) {
    ViewFrame frame;
    for (const Side side : {Side::Top, Side::Front, Side::Left}) {
        frame = frameOfSide(side, up);
        if (frame.towards_viewer[section.axis] != 0) break;
    }
    frame.side = Side::Other;
    frame.name = std::string("Section ") + axes[std::size_t(section.axis)] + " = " +
                 inDigits(100 * section.share, 3) + " %";
    return frame;
}

std::string frameInWords(const ViewFrame& frame) {
    constexpr int digits = 9;
    std::string words = toward;
    const auto add = [&](const Vector3d& vector) {
        for (const double x : vector)
            words += ' ' + inDigits(x + 0., digits);  // no -0
    };
    add(frame.towards_viewer);
    add(frame.up);
    if (!frame.eye) return words;
    words += std::string(" ") + from;
    add(*frame.eye);
    return words;
}

std::vector<ViewFrame> parseViews(std::string_view text, UpAxis up, const NamedViews& others) {
    return ViewWords(text, up, others).read();
}

}  // namespace line_drawing
