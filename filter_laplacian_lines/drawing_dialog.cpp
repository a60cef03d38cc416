// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_dialog.h"

#include <QCheckBox>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTimer>

using meshlab_host::FilterDialog;

namespace {

constexpr int pause_of_typing = 150;  // ms
constexpr int marks_in_a_row = 4;
constexpr int outlook_lines = 3;

/// Owned by the dialog.
class DrawingDialog : public QObject {
public:
    DrawingDialog(FilterDialog dialog, const MeshDocument& document)
        : QObject(dialog.frame()), dialog_(dialog), document_(&document) {
        dialog_.tighten();
        update_soon_.setSingleShot(true);
        update_soon_.setInterval(pause_of_typing);
        connect(&update_soon_, &QTimer::timeout, this, [this] { update(); });
        dialog_.whenChanged(this, [this] { fieldsChanged(); });
        addMarks();
        addOutlook();
        dialog_.frame()->installEventFilter(this);
    }

    void show(const std::vector<DrawingField>& fields) {
        for (const DrawingField& field : fields)
            dialog_.setText(field.label, field.text);
        fieldsChanged();
    }

    void addBrowsing() {
        auto* button = new QPushButton("...", dialog_.frame());
        button->setMaximumWidth(2 * button->fontMetrics().height());
        connect(button, &QPushButton::clicked, this, [this] { browse(); });
        if (!dialog_.addBeside(drawing_labels::file, button)) delete button;
    }

protected:
    /// The window's view, or a layer, may have changed.
    bool eventFilter(QObject* receiver, QEvent* event) override {
        if (event->type() == QEvent::Enter) update_soon_.start();
        return QObject::eventFilter(receiver, event);
    }

private:
    void addMarks() {
        auto* marks = new QWidget(dialog_.frame());
        auto* grid = new QGridLayout(marks);
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setSpacing(0);
        for (const QString& view : viewsWithMarks()) {
            auto* mark = new QCheckBox(view.left(1).toUpper() + view.mid(1), marks);
            grid->addWidget(mark, marks_.size() / marks_in_a_row, marks_.size() % marks_in_a_row);
            connect(mark, &QCheckBox::clicked, this, [this, view](bool is_wanted) {
                const QString text = dialog_.text(drawing_labels::views).value_or("");
                dialog_.setText(drawing_labels::views, withView(text, view, is_wanted));
            });
            marks_ << mark;
        }
        if (!dialog_.addBelow(drawing_labels::views, marks)) delete marks, marks_.clear();
    }

    void addOutlook() {
        outlook_ = new QLabel(dialog_.frame());
        outlook_->setWordWrap(true);
        outlook_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        outlook_->setFixedHeight(outlook_lines * outlook_->fontMetrics().lineSpacing());
        dialog_.addLine(outlook_);
    }

    void fieldsChanged() {
        const QStringList views = viewsWithMarks();
        const QString text = dialog_.text(drawing_labels::views).value_or("");
        for (int i = 0; i < marks_.size(); ++i)
            marks_[i]->setChecked(hasView(text, views[i]));
        update_soon_.start();
    }

    void update() {
        if (!document_) return;
        const auto text_of = [this](const QString& label) { return dialog_.text(label); };
        const std::optional<QString> words = outlook_of_.inWords(*document_, text_of);
        if (!words) return update_soon_.start();
        outlook_->setText(*words);
        outlook_->setToolTip(*words);
    }

    void browse() {
        const QString chosen = QFileDialog::getSaveFileName(
            dialog_.frame(), "Save Drawing", dialog_.text(drawing_labels::file).value_or(""),
            drawing_files);
        if (!chosen.isEmpty()) dialog_.setText(drawing_labels::file, chosen);
    }

    FilterDialog dialog_;
    QPointer<const MeshDocument> document_;
    DrawingOutlook outlook_of_;
    QList<QCheckBox*> marks_;
    QLabel* outlook_ = nullptr;
    QTimer update_soon_;
};

}  // namespace

void furnishDrawingDialog(FilterDialog dialog, const DrawingParameters& defaults,
                          const MeshDocument& document) {
    auto* furnished = new DrawingDialog(dialog, document);
    if (meshlab_host::needsBrowsing()) furnished->addBrowsing();
    const MeshModel* mesh = document.mm();
    furnished->show(keptSettings(defaults, mesh ? mesh->fullName() : QString()));
}
