// What a flythrough looked like when it was recorded, and whether it still does.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/messages.h"
#include "base/result.h"
#include "flight/comparison.h"
#include "flight/flight.h"

namespace enfilade {

// Pictures and a page about frames that are not what they should be.

// The pictures that lie beside a recording for the human eye: small ones on one sheet, and full-size ones where
// somebody asked for them.

/// The picture of all small ones: "tour.sheet.png" of "tour.toml".
std::string sheet_path(const std::string& script_path);

/// A file of a part of a recording: "tour.part-000000-000099.hashes" of "tour.toml" and ".hashes".
std::string part_path(const std::string& script_path, int first, int last, const std::string& ending);

/// The sheet at `path`, if it is that of a recording with such a sheet; else a sentence that says why there is none.
Result<ContactSheet> read_sheet(const std::string& path, const std::optional<std::uint64_t>& recorded,
                                ContactSheet empty);

/// What a recording keeps beside its hashes.
struct PictureKeeping {
    bool no_pictures = false;
    int full_size_every = 0;  ///< each so-many-th frame also as it is; 0: those of which there is one already
};

/// Keeps the pictures of one recording while its frames are drawn.
class PictureKeeper {
public:
    /// The plan may have a part of the flight's frames only, of which there are so many.
    PictureKeeper(const std::string& script_path, const DrawPlan& plan, int flight_frames,
                  const PictureKeeping& keeping);

    /// Makes the folder that is needed.
    Result<void> start() const;
    /// A FrameTaker: of any thread, each frame once.
    Result<void> take(int number, const Frame& frame);
    /// Writes the sheet where one is wanted. The hash by which the recording knows it.
    Result<std::optional<std::uint64_t>> finish() const;
    /// Once the recording's hashes are in place: removes pictures that are not kept any more.
    Result<void> remove_surplus(const std::string& hashes) const;

private:
    std::string sheet_, folder_;  ///< paths
    PictureKeeping keeping_;
    std::vector<int> before_, full_size_;  ///< frames that have a full-size picture, and that shall have one
    ContactSheet contact_sheet_;
};

/// A picture that was kept: of the frame's size, or `reduction` times smaller.
struct KeptPicture {
    Frame picture;
    int reduction = 1;
};

/// What was kept of a recording. Only pictures that belong to it: files may be of another day.
class KeptPictures {
public:
    KeptPictures(const std::string& script_path, const FrameRecording& recording, const DrawPlan& plan);

    /// The frame as it was recorded, full-size if that was kept.
    std::optional<KeptPicture> of(const FrameHash& recorded) const;

    /// Why there are no small pictures, as a sentence; empty: there are.
    const std::string& what_is_missing() const { return missing_; }

private:
    std::string folder_, missing_;
    int reduction_;
    ContactSheet sheet_;
};

/// A frame that differs, with both its pictures.
struct BadFrame {
    Mismatch mismatch;
    std::optional<Frame> expected;  ///< none: nobody knows what it looked like
    Frame actual;
    std::string expected_origin;  ///< as in MismatchRow
    int reduction = 1;            ///< of expected, which is compared with the actual picture reduced as much
};

/// Frames that a report shows; more would be more than anybody looks at.
inline constexpr std::size_t kMostShown = 12;

/// Takes out of the folder what an earlier report put there, and the folder where nothing else is in it: `of_file`,
/// which it was about, is as it should be now. What is not a report's stays.
Result<void> remove_report(const std::string& folder, const std::string& of_file);

/// Writes the pictures and index.html into the folder, which is made where it is missing, instead of an earlier report,
/// whose surplus pictures go last.
Result<void> write_report(const std::string& folder, const ReportText& text, const std::vector<BadFrame>& frames);

/// Draws the frames of the plan and writes their hashes, and beside them the pictures that shall be kept. Where the
/// plan has not all frames of the flight, into the files of a part, for merge_parts().
Result<void> record_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                           const PictureKeeping& keeping, Talk talk);

/// Makes the recording of all frames of the flight from its parts, which may have been drawn on several machines: the
/// same bytes as if it had been recorded at once. Then removes the parts. An error where frames are missing.
Result<void> merge_parts(const std::string& script_path, int frames);

/// What comparing frames came to.
struct FlightVerdict {
    std::vector<int> differing;  ///< frames, growing
    std::string report;          ///< the page that shows some of them; empty where none differs
};

/// Draws the frames of the plan and compares each with its recorded hash. An error where frames of another number, size
/// or renderer were recorded. Where some differ, report_folder holds pictures of a few and a page, index.html, that
/// shows them: expected, as it was kept when it was recorded, actual, and the difference. Nothing else is ever shown as
/// expected; where nothing was kept, the page and stderr say so.
Result<FlightVerdict> check_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                                   const std::string& report_folder, Talk talk);

/// Draws the frames of the plan with two renderers. Those differ of which more than `tolerance` of the pixels (0..1)
/// do; with the same report.
Result<FlightVerdict> compare_renderers(const FlightScene& scene, const DrawPlan& plan, RendererKind other,
                                        double tolerance, const std::string& report_folder, Talk talk);

}  // namespace enfilade
