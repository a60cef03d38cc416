// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/view_frame.h"

#include <Eigen/Geometry>
#include <cmath>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

using Eigen::Vector3d;

constexpr std::array<const char*, 6> side_names = {"Front", "Back", "Left",
                                                   "Right", "Top",  "Bottom"};

Vector3d upOf(UpAxis axis) {
    return Vector3d::Unit(int(axis));
}

Vector3d frontOf(UpAxis axis) {
    return axis == UpAxis::Z ? Vector3d(0, -1, 0) : Vector3d(0, 0, 1);
}

ViewFrame makeFrame(Side side, const QString& name, const Vector3d& towards_viewer,
                    const Vector3d& up) {
    return {side, name, up.cross(towards_viewer), up, towards_viewer, false};
}

class ViewWords {
public:
    ViewWords(const QString& text, UpAxis up, const NamedViews& others)
        : words_(wordsOf(text)), up_(up), others_(others) {}

    std::vector<ViewFrame> read() {
        std::vector<ViewFrame> views;
        while (next_ < words_.size()) {
            const QString word = words_[next_++];
            if (word.compare("six", Qt::CaseInsensitive) == 0)
                for (std::size_t side = 0; side < side_names.size(); ++side)
                    views.push_back(frameOfSide(Side(side), up_));
            else
                views.push_back(readOne(word));
        }
        if (views.empty()) refuseWord("");
        return views;
    }

private:
    ViewFrame readOne(const QString& word) {
        for (std::size_t side = 0; side < side_names.size(); ++side)
            if (word.compare(side_names[side], Qt::CaseInsensitive) == 0)
                return frameOfSide(Side(side), up_);
        if (word.compare("vessel", Qt::CaseInsensitive) == 0) return frameOfVessel(up_);
        for (const auto& [name, frame] : others_)
            if (word.compare(name, Qt::CaseInsensitive) == 0) return frame;
        bool is_number = false;
        const double azimuth = word.toDouble(&is_number);
        if (!is_number || next_ == words_.size()) refuseWord(word);
        const double elevation = words_[next_++].toDouble(&is_number);
        if (!is_number) refuseWord(words_[next_ - 1]);
        return frameOfDirection(azimuth, elevation, up_);
    }

    [[noreturn]] static void refuseWord(const QString& word) {
        refuse(QString("\"%1\" is not a view. Views are front, back, left, right, top, bottom, "
                       "six (all of these), vessel, or azimuth and elevation in degrees, such "
                       "as 30,15.")
                   .arg(word));
    }

    const QStringList words_;
    const UpAxis up_;
    const NamedViews& others_;
    int next_ = 0;
};

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
    const QString name = side_names[std::size_t(side)];
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

ViewFrame frameOfVessel(UpAxis axis) {
    ViewFrame frame = frameOfSide(Side::Front, axis);
    frame.name = "Vessel";
    frame.is_half_section = true;
    return frame;
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
    const QString name = QString("%1°, %2°").arg(azimuth).arg(elevation);
    return makeFrame(Side::Other, name, std::cos(e) * outwards + std::sin(e) * up,
                     std::cos(e) * up - std::sin(e) * outwards);
}

std::vector<ViewFrame> parseViews(const QString& text, UpAxis up, const NamedViews& others) {
    return ViewWords(text, up, others).read();
}

}  // namespace line_drawing
