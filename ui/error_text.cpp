#include "ui/error_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <iterator>

namespace hedr {
namespace {

// %1 is the subject, in the advice, too. The detail, where there is one, follows `what` after a
// colon.
struct Sentence {
    ErrorCode code;
    const char* what;
    const char* advice;
};

constexpr const char* kContext = "ErrorText";

constexpr Sentence kSentences[] = {
    {ErrorCode::kFileMissing, QT_TRANSLATE_NOOP("ErrorText", "There is no file %1"),
     QT_TRANSLATE_NOOP("ErrorText", "Check the spelling and the folder.")},
    {ErrorCode::kFileUnreadable, QT_TRANSLATE_NOOP("ErrorText", "%1 cannot be read"),
     QT_TRANSLATE_NOOP("ErrorText", "Check that your user may read it: ls -l shows the owner.")},
    {ErrorCode::kFileEmpty, QT_TRANSLATE_NOOP("ErrorText", "%1 is empty"),
     QT_TRANSLATE_NOOP("ErrorText", "Choose a file that has data in it.")},
    {ErrorCode::kFileTooLarge, QT_TRANSLATE_NOOP("ErrorText", "%1 is too large"),
     QT_TRANSLATE_NOOP("ErrorText", "Cut out the part that you need.")},
    {ErrorCode::kFileUnwritable, QT_TRANSLATE_NOOP("ErrorText", "%1 cannot be written"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Choose a folder that exists and that your user may write to.")},
    {ErrorCode::kFileExists, QT_TRANSLATE_NOOP("ErrorText", "There is a file %1 already"),
     QT_TRANSLATE_NOOP("ErrorText", "Nothing is replaced: choose another name.")},
    {ErrorCode::kFileChanged,
     QT_TRANSLATE_NOOP("ErrorText", "%1 is not the file that it was: it has changed since"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Put back the earlier file; a plan may be checked and aligned again.")},
    {ErrorCode::kBadFormat, QT_TRANSLATE_NOOP("ErrorText", "%1 is not understood"),
     QT_TRANSLATE_NOOP("ErrorText", "Correct it there, or take a fresh copy of the file.")},
    {ErrorCode::kMissingColumn, QT_TRANSLATE_NOOP("ErrorText", "%1 lacks a needed column"),
     QT_TRANSLATE_NOOP("ErrorText", "Add the column to the header row and to every line.")},
    {ErrorCode::kMissingKey, QT_TRANSLATE_NOOP("ErrorText", "%1 lacks what is needed"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Add each key that is named, with its value, on its own line.")},
    {ErrorCode::kBadValue, QT_TRANSLATE_NOOP("ErrorText", "%1 has a value that cannot be used"),
     QT_TRANSLATE_NOOP("ErrorText", "Correct the value and try again.")},
    {ErrorCode::kUnknownName, QT_TRANSLATE_NOOP("ErrorText", "The name %1 is not known"),
     QT_TRANSLATE_NOOP("ErrorText", "Check the spelling against the list of names.")},
    {ErrorCode::kNotAnImage, QT_TRANSLATE_NOOP("ErrorText", "%1 is not an image that can be read"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Choose an image (PNG, JPEG, TIFF, …), a PDF, a drawing or a map.")},
    {ErrorCode::kImageTooLarge, QT_TRANSLATE_NOOP("ErrorText", "The image %1 is too large"),
     QT_TRANSLATE_NOOP("ErrorText", "Scale it down or cut out the part that you need.")},
    {ErrorCode::kKeyExposed,
     QT_TRANSLATE_NOOP("ErrorText", "Others than you may read or replace the secret %1"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Take their rights away, and make a new key if somebody may have used them: "
                       "chmod go-rwx '%1'.")},
    {ErrorCode::kPortMissing, QT_TRANSLATE_NOOP("ErrorText", "There is no port %1"),
     QT_TRANSLATE_NOOP("ErrorText", "Plug the radio in, or choose another port.")},
    {ErrorCode::kOtherWheels,
     QT_TRANSLATE_NOOP("ErrorText",
                       "%1 has other wheels than those that the robot was taken to have"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "It keeps its own, for a wheelbase belongs to its wheels. Connect with that "
                       "vehicle file, and calibrate again.")},
    {ErrorCode::kNotAPort, QT_TRANSLATE_NOOP("ErrorText", "%1 is not a serial port"),
     QT_TRANSLATE_NOOP("ErrorText", "Choose the radio's, such as /dev/ttyUSB0.")},
    {ErrorCode::kPortPermission, QT_TRANSLATE_NOOP("ErrorText", "Your user may not open %1"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Add it to the dialout group: sudo usermod -aG dialout $USER, "
                       "then log in again.")},
    {ErrorCode::kPortBusy, QT_TRANSLATE_NOOP("ErrorText", "Another program is using %1"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Close it, then connect again. The udev rule 70-hedr.rules keeps modem "
                       "services away for good.")},
    {ErrorCode::kPortFailed, QT_TRANSLATE_NOOP("ErrorText", "The port %1 failed"),
     QT_TRANSLATE_NOOP("ErrorText", "Check the cable and the radio's power.")},
    {ErrorCode::kPeerMissing, QT_TRANSLATE_NOOP("ErrorText", "No robot at %1"),
     QT_TRANSLATE_NOOP("ErrorText", "Check its power, the network and the address.")},
    {ErrorCode::kAddressInUse, QT_TRANSLATE_NOOP("ErrorText", "%1 cannot be listened to"),
     QT_TRANSLATE_NOOP("ErrorText", "Close the program that listens there, or use another port.")},
    {ErrorCode::kReplayGap, QT_TRANSLATE_NOOP("ErrorText", "%1 is silent here"),
     QT_TRANSLATE_NOOP("ErrorText", "Wait: what was recorded next comes in its own time.")},
    {ErrorCode::kReplayEnded, QT_TRANSLATE_NOOP("ErrorText", "Nothing more comes from %1"),
     QT_TRANSLATE_NOOP("ErrorText", "Connect again to begin anew.")},
    {ErrorCode::kUnreachable, QT_TRANSLATE_NOOP("ErrorText", "Nothing can be sent to %1"),
     QT_TRANSLATE_NOOP("ErrorText", "Check the address and the network.")},
    {ErrorCode::kNotOnGlobe,
     QT_TRANSLATE_NOOP("ErrorText", "%1 needs latitude and longitude, which are not known here"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Tie the map to the globe (G) by two places with their coordinates.")},
    {ErrorCode::kDiskFull, QT_TRANSLATE_NOOP("ErrorText", "The disk of %1 is full"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Nothing that was written before is lost. Make room, or choose another "
                       "disk.")},
    {ErrorCode::kNotAMission, QT_TRANSLATE_NOOP("ErrorText", "%1 is not a mission file"),
     QT_TRANSLATE_NOOP("ErrorText", "Choose a file that was recorded by this program (.hedr).")},
    {ErrorCode::kMissionTooNew,
     QT_TRANSLATE_NOOP("ErrorText", "%1 was recorded by a newer version of this program"),
     QT_TRANSLATE_NOOP("ErrorText", "Update this program to open it.")},
    {ErrorCode::kMissionDamaged, QT_TRANSLATE_NOOP("ErrorText", "The mission file %1 is damaged"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Keep it: hedr recover FILE --out NEW writes what is left of it to a new "
                       "file.")},
    {ErrorCode::kMissionBusy,
     QT_TRANSLATE_NOOP("ErrorText", "Another program is recording into the mission %1"),
     QT_TRANSLATE_NOOP("ErrorText", "End it there, or choose another file.")},
    {ErrorCode::kMissionSigned,
     QT_TRANSLATE_NOOP("ErrorText", "Nothing in the mission %1 could be believed"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Compute it with the robot's key: hedr fuse --key NAME; hedr key list shows "
                       "those that are here.")},
    {ErrorCode::kMissionIncomplete,
     QT_TRANSLATE_NOOP("ErrorText", "The mission file %1 is damaged, what is left of it is read"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Keep it: hedr recover FILE --out NEW writes what is left of it to a new "
                       "file.")},
    {ErrorCode::kMissionMoved,
     QT_TRANSLATE_NOOP("ErrorText", "The mission file was damaged, the mission goes on in %1"),
     QT_TRANSLATE_NOOP("ErrorText", "The damaged file stays as it is.")},
    {ErrorCode::kWheelsUnknown,
     QT_TRANSLATE_NOOP("ErrorText", "%1 does not say how its wheels are made"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Choose its vehicle file when you connect; until then trails that use the "
                       "wheels are a guess.")},
    {ErrorCode::kSensorsRare, QT_TRANSLATE_NOOP("ErrorText", "%1 says too seldom how it moves"),
     QT_TRANSLATE_NOOP("ErrorText",
                       "Let it send its sensors at least 10 times a second; until then quick turns "
                       "are lost.")},
    {ErrorCode::kNoData, QT_TRANSLATE_NOOP("ErrorText", "%1 has no data for this"),
     QT_TRANSLATE_NOOP("ErrorText", "Choose a longer recording, or one with the needed sensors.")},
    {ErrorCode::kCalibrationRefused, QT_TRANSLATE_NOOP("ErrorText", "%1 is refused"),
     QT_TRANSLATE_NOOP("ErrorText", "The vehicle file stays as it was.")},
    {ErrorCode::kCanceled, QT_TRANSLATE_NOOP("ErrorText", "%1 was canceled"),
     QT_TRANSLATE_NOOP("ErrorText", "Start it again when you want it.")},
};

QString translated(const char* text) { return QCoreApplication::translate(kContext, text); }

QString withoutFullStop(QString text) {
    while (text.endsWith(u'.') || text.endsWith(u' ')) text.chop(1);
    return text;
}

}  // namespace

QString errorText(const Error& error) {
    const auto* sentence =
        std::find_if(std::begin(kSentences), std::end(kSentences),
                     [&](const Sentence& entry) { return entry.code == error.code; });
    if (sentence == std::end(kSentences)) return QString::fromStdString(error.detail);
    const QString subject = error.subject.empty() ? translated(QT_TRANSLATE_NOOP("ErrorText", "It"))
                                                  : QString::fromStdString(error.subject);
    QString text = translated(sentence->what).arg(subject);
    const QString detail = withoutFullStop(QString::fromStdString(error.detail));
    if (!detail.isEmpty()) text += QStringLiteral(": ") + detail;
    return text + QStringLiteral(". ") +
           translated(sentence->advice).replace(QLatin1String("%1"), subject);
}

QString lineToCopy(const QString& text) {
    static const QRegularExpression line(
        QStringLiteral(": ((?:sudo|kill|chmod) .+?)(?=[.,;](?: |$)|$)"));
    return line.match(text).captured(1);
}

}  // namespace hedr
