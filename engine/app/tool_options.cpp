#include "app/commands.h"

#include <CLI/CLI.hpp>

namespace enfilade {

AccuracyCommand::AccuracyCommand(CLI::App& enfilade) {
    CLI::App* command = enfilade.add_subcommand("accuracy", "Measure what accuracy costs in time");
    command->add_option("MAP", request_.maps, "Maps to measure in; if none is given, some that come with Enfilade");
    command
        ->add_option("--out", request_.out,
                     "A folder for the report: README.md, report.json, accuracy.csv, accuracy.svg, scenes.svg")
        ->type_name("DIR");
    command->add_flag("--quick", request_.quick, "Fewer places and settings: under a minute");
    command
        ->add_option("--verify", request_.verify,
                     "The report.json of an earlier run: fail unless its errors are found again")
        ->type_name("FILE.json");
    command
        ->add_option("--export", request_.export_to,
                     "Measure nothing: write views, and true colours and surfaces as pictures, for other renderers to "
                     "be held against")
        ->type_name("DIR");
    command
        ->add_option("--score", request_.score,
                     "Measure nothing: hold pictures of those views against the true ones, in folders as --export "
                     "writes them")
        ->type_name("DIR")
        ->excludes("--export");
    command->add_flag("--resume", request_.resume, "Go on with the report in --out, where it was cut off");
    command->add_option("--textures", request_.texture_folders, "More folders to look for pictures in")
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

int AccuracyCommand::run() const { return run_accuracy(request_); }

namespace {

CLI::App* declare_new(CLI::App& enfilade, NewRequest& request) {
    CLI::App* command = enfilade.add_subcommand("new", "Write a small map to begin from");
    command->add_option("NAME", request.name, "The file, with or without .toml; one that is there is not overwritten")
        ->required();
    command->footer(
        "The map has two rooms, a door and a lamp, and uses the pictures that come with Enfilade. maps/GUIDE.md goes "
        "on "
        "from it.\nExit status: 0 written, 1 there is such a file, or it cannot be written, 2 wrong usage.");
    return command;
}

CLI::App* declare_expand(CLI::App& enfilade, ExpandRequest& request) {
    CLI::App* command =
        enfilade.add_subcommand("expand", "Write out openings, rectangles, polygons and prefabs of a map");
    command->add_option("MAP", request.map, "The map file (.toml)")->required();
    command->add_option("--out", request.out, "Where to write the map; to standard output if not given")
        ->type_name("FILE.toml");
    command->footer(
        "What is written is the same map without short words, comments and prefabs. It belongs beside MAP, because its "
        "folders of pictures and sounds are seen from there.\nExit status: 0 done, 1 the map has errors, 2 wrong "
        "usage.");
    return command;
}

CLI::App* declare_fmt(CLI::App& enfilade, FmtRequest& request) {
    CLI::App* command = enfilade.add_subcommand("fmt", "Lay out map files anew: blanks, lines, comments in columns");
    command->add_option("MAP", request.maps, "Map files (.toml), or folders: all maps in them")->required();
    command->add_flag("--check", request.check, "Change nothing; tell which maps are laid out otherwise");
    command->footer(
        "Comments, values and the order of everything stay as they are. Each file that is changed is printed.\nExit "
        "status: 0 done, 1 a file is not valid TOML or cannot be written, or with --check is laid out otherwise, 2 "
        "wrong "
        "usage.");
    return command;
}

void declare_draw(CLI::App& enfilade, DrawRequest& request) {
    CLI::App* command =
        enfilade.add_subcommand("draw", "Draw the plan of a map: walls, names, numbers, links, triggers");
    command->add_option("MAP", request.map, "The map file (.toml)")->required();
    command->add_option("--out", request.out, "The picture; - for standard output")->type_name("FILE.svg")->required();
    command->footer(
        "Pointing at a part of the picture in a browser tells its line in the file. A map with errors is drawn as far "
        "as "
        "it could be read.\nExit status: 0 done, 1 the map has errors or the picture cannot be written, 2 wrong "
        "usage.");
}

}  // namespace

AuthorCommands::AuthorCommands(CLI::App& enfilade)
    : declared_new_(declare_new(enfilade, new_)),
      declared_expand_(declare_expand(enfilade, expand_)),
      declared_fmt_(declare_fmt(enfilade, fmt_)) {
    declare_draw(enfilade, draw_);
}

int AuthorCommands::run() const {
    if (declared_new_->parsed()) return run_new(new_);
    if (declared_expand_->parsed()) return run_expand(expand_);
    if (declared_fmt_->parsed()) return run_fmt(fmt_);
    return run_draw(draw_);
}

}  // namespace enfilade
