// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <QWidget>

namespace driver {

// Sets the field with this label as a user would. CommandError if there is none or it refuses.
//   check box: on or off; combo box: text or number of an entry; percentage: 0.1 (absolute) or 5%;
//   point: "x y z" or "View Pos."; colour: #rrggbb or a name
void setField(QWidget* container, const QString& label, const QString& value);

// From a command's words: LABEL = VALUE.
struct Command;
void setFieldFromCommand(QWidget* container, const Command& command);

// "on" or "off" for a check box.
QString textOfField(QWidget* container, const QString& label);

// "hidden", "off" if the user cannot change it, or "on".
QString stateOfField(QWidget* container, const QString& label);

}  // namespace driver
