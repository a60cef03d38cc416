// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a script, one command after the other, in MeshLab's own event loop: a command may open a
// box, in whose event loop the next ones run, and one that has to wait is tried again.
#include <QApplication>
#include <QProgressBar>
#include <QTimer>

#include "command_table.h"
#include "gui.h"
#include "process.h"

namespace driver {
namespace {

constexpr int kBetweenCommands = 60;  // ms, so that MeshLab's own queued events run first
constexpr int kBetweenRetries = 50;   // ms

std::string describe(const Command& command) {
    const QString text =
        QString("line %1: %2 %3").arg(command.line).arg(command.name, command.rest);
    return text.trimmed().toStdString();
}

[[noreturn]] void end_at(const Command& command, const std::exception& why) {
    say(std::string("reason: ") + why.what());  // on a line of its own, for ./run
    end_with_error(describe(command) + ": " + why.what());
}

class Runner : public QObject {
public:
    Runner(QVector<Command> script, CommandTable table, QObject* parent);

private:
    void add_own_commands();
    void check_names() const;
    void schedule_step(int milliseconds);
    void step();
    bool answers(QWidget* modal);
    void start(const Command& command);
    void together(const Command& command);

    QVector<Command> script_;
    CommandTable table_;
    unsigned time_limit_ = 60;  // seconds
    // More than one when a command sits in a modal box's event loop.
    QVector<Command> in_progress_;
    int next_ = 0;
    int watched_line_ = 0;
};

Runner::Runner(QVector<Command> script, CommandTable table, QObject* parent)
    : QObject(parent), script_(std::move(script)), table_(std::move(table)) {
    add_own_commands();
    check_names();
    watch("waiting for MeshLab's main window", time_limit_);
    schedule_step(kBetweenCommands);
}

void Runner::add_own_commands() {
    table_["time-limit"] = {[this](const Command& c) { time_limit_ = unsigned(c.number(0)); }};
    table_["together"] = {[this](const Command& c) { together(c); }};
    table_["quit"] = {[](const Command&) { end_process(0); }};
}

// Misspelt commands fail at once, not after minutes.
void Runner::check_names() const {
    for (const Command& command : script_) {
        try {
            find(table_, command.name);
        } catch (const CommandError& e) {
            end_at(command, e);
        }
    }
}

// A single shot: a repeating timer would not fire inside the event loop of a modal box that its own
// slot has opened.
void Runner::schedule_step(int milliseconds) {
    QTimer::singleShot(milliseconds, this, &Runner::step);
}

void Runner::step() {
    QWidget* window = main_window();
    if (!window || !window->isVisible()) return schedule_step(kBetweenRetries);
    if (watched_line_ == 0)  // before the first command
        for (QProgressBar* bar : window->findChildren<QProgressBar*>())
            connect(bar, &QProgressBar::valueChanged, this, [] { restart_watch(); });
    QWidget* modal = QApplication::activeModalWidget();
    // Without a box, it is a filter's progress that runs the event loop.
    const bool has_to_wait = !modal && !in_progress_.isEmpty();
    if (next_ >= script_.size() && in_progress_.isEmpty())
        return watch("", 0);  // no "quit" at the end: the user goes on by hand
    try {
        if (has_to_wait || (modal && answers(modal))) return schedule_step(kBetweenRetries);
        if (next_ < script_.size()) start(script_[next_]);
    } catch (const std::exception& e) {  // must not travel through Qt's event loop
        end_at(in_progress_.isEmpty() ? script_[next_] : in_progress_.last(), e);
    }
}

/// Otherwise it is left to the next command.
bool Runner::answers(QWidget* modal) {
    if (accept_options_box(modal)) return true;
    if (!in_progress_.isEmpty() &&
        find(table_, in_progress_.last().name).boxes == Boxes::Answered) {
        answer_box(modal);
        return true;
    }
    if (next_ < script_.size() && find(table_, script_[next_].name).boxes == Boxes::Subject)
        return false;
    throw CommandError("MeshLab says: " + describe_box(modal));
}

void Runner::start(const Command& command) {
    if (watched_line_ != command.line) {  // otherwise it is retried: its time goes on
        watched_line_ = command.line;
        say(describe(command));
        watch(describe(command), time_limit_);
    }
    const int position = next_++;
    schedule_step(kBetweenCommands);  // before the command, which may block in a modal box
    in_progress_ << command;
    try {
        find(table_, command.name).handle(command);
    } catch (const NotYet&) {
        next_ = position;
    }
    in_progress_.removeLast();
}

// COMMAND ; COMMAND...
void Runner::together(const Command& command) {
    for (const QString& text : command.rest.split(" ; ")) {
        const Command part = parse_line(text.trimmed());
        try {
            find(table_, part.name).handle(part);
        } catch (const NotYet&) {
            throw CommandError(part.name + " takes longer");
        }
    }
}

}  // namespace

void run_script(const QString& file_name, QObject* parent) {
    new Runner(read_script(file_name), all_commands(), parent);
}

}  // namespace driver
