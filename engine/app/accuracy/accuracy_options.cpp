#include "app/accuracy/accuracy_options.h"

#include <CLI/CLI.hpp>

namespace enfilade {

AccuracyCommand::AccuracyCommand(CLI::App& enfilade) {
    AccuracyRequest& request = *request_;
    CLI::App* command = enfilade.add_subcommand("accuracy", "Measure what accuracy costs in time");
    command->add_option("MAP", request.maps, "Maps to measure in; if none is given, some that come with Enfilade");
    command
        ->add_option("--out", request.out,
                     "A folder for the report: README.md, report.json, accuracy.csv, accuracy.svg, scenes.svg")
        ->type_name("DIR");
    command->add_flag("--quick", request.quick, "Fewer places and settings: under a minute");
    command
        ->add_option("--verify", request.verify,
                     "The report.json of an earlier run: fail unless its errors are found again")
        ->type_name("FILE.json");
    command
        ->add_option("--export", request.export_to,
                     "Measure nothing: write views, and true colours and surfaces as pictures, for other renderers to "
                     "be held against")
        ->type_name("DIR");
    command
        ->add_option("--score", request.score,
                     "Measure nothing: hold pictures of those views against the true ones, in folders as --export "
                     "writes them")
        ->type_name("DIR")
        ->excludes("--export");
    command->add_flag("--resume", request.resume, "Go on with the report in --out, where it was cut off");
    command->add_option("--textures", request.texture_folders, "More folders to look for pictures in")
        ->type_name("DIR")
        ->allow_extra_args(false);
    command->footer(
        "Draws rooms by every accuracy and dial (see `render --help`), and holds what each pixel shows against places "
        "on "
        "pictures worked out in numbers of 113 bits. Instructions are counted where valgrind is installed, the picture "
        "is drawn where gnuplot is.\nExit status: 0 every promise is kept, 1 one is broken or something is at fault, 2 "
        "wrong usage.");
    declared_ = command;
}

bool AccuracyCommand::is_asked_for() const { return declared_->parsed(); }

int AccuracyCommand::run() const { return run_accuracy(*request_); }

}  // namespace enfilade
