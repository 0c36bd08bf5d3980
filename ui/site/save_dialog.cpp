#include "ui/site/save_dialog.h"

#include <QFileInfo>
#include <QLineEdit>

#include "ui/site/file_dialog_look.h"

namespace hedr {

SaveDialog::SaveDialog(const SaveQuestion& question, const Theme& theme, QWidget* parent)
    : QFileDialog(parent, question.title), suffix_(question.suffix) {
    setAcceptMode(QFileDialog::AcceptSave);
    dress(*this, theme);
    setFileMode(QFileDialog::AnyFile);
    setNameFilter(QStringLiteral("%1 (*%2)").arg(question.kind, question.suffix));
    setLabelText(QFileDialog::LookIn, tr("Folder:"));
    setLabelText(QFileDialog::FileName, tr("Name:"));
    setLabelText(QFileDialog::FileType, tr("Kind:"));
    setLabelText(QFileDialog::Accept, tr("Save"));
    const QFileInfo proposal(question.proposal);
    setDirectory(proposal.path());
    selectFile(proposal.fileName());
    resize(860, 560);
}

void SaveDialog::accept() {
    auto* name = findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    const QString typed = name ? name->text().trimmed() : QString();
    const bool is_folder = QFileInfo(directory(), typed).isDir();
    if (!typed.isEmpty() && !is_folder && !typed.endsWith(suffix_, Qt::CaseInsensitive)) {
        name->setText(typed + suffix_);
    }
    QFileDialog::accept();
}

}  // namespace hedr
