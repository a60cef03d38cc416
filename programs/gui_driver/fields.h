// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <QWidget>

namespace driver {

// Gives the field with this label the value, as if the user had typed it. CommandError when there
// is no such field or it does not take the value.
//   check box: on or off               combo box: the text or the number of an entry
//   percentage: 0.1 (absolute) or 5%   point: "x y z", "View Pos."              colour: #rrggbb or
//   a name
void setField(QWidget* container, const QString& label, const QString& value);

// The same for the words of a command: LABEL = VALUE.
struct Command;
void setFieldFromCommand(QWidget* container, const Command& command);

// What the field shows, of a check box "on" or "off".
QString textOfField(QWidget* container, const QString& label);

// What a user sees of the field: "hidden", "off" if its value cannot be changed, or "on".
QString stateOfField(QWidget* container, const QString& label);

}  // namespace driver
