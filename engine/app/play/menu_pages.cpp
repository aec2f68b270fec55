// What the pages of the menu say.
#include <fmt/format.h>

#include "app/play/menu.h"

namespace enfilade {
namespace {

MenuRow action(std::string label, MenuAction what, std::string hint = {}) {
    MenuRow row{std::move(label)};
    row.hint = std::move(hint);
    row.choice.action = what;
    return row;
}

MenuRow to_page(std::string label, MenuPage page) {
    MenuRow row{std::move(label)};
    row.page = page;
    return row;
}

MenuRow to_read(std::string label, std::string value = " ") { return {std::move(label), std::move(value)}; }

std::vector<MenuRow> title_rows(const MenuFacts& facts) {
    std::vector<MenuRow> rows;
    if (!facts.last_map.empty())
        rows.push_back(action("Continue", MenuAction::go_on, "Where you were last: " + facts.last_map));
    rows.push_back(action("Maps", MenuAction::maps));
    rows.push_back(to_page("Options", MenuPage::options));
    rows.push_back(to_page("Controls", MenuPage::controls));
    rows.push_back(to_page("Help", MenuPage::help));
    rows.push_back(action("Quit", MenuAction::quit));
    return rows;
}

std::vector<MenuRow> pause_rows() {
    return {action("Resume", MenuAction::resume),
            action("Save game", MenuAction::save, "The two games saved before are kept beside it."),
            action("Load game", MenuAction::load),
            action("Restart map", MenuAction::restart),
            to_page("Views", MenuPage::views),
            to_page("Options", MenuPage::options),
            to_page("Controls", MenuPage::controls),
            to_page("Help", MenuPage::help),
            action("Title screen", MenuAction::to_title, "The game is kept; Continue goes on with it."),
            action("Quit", MenuAction::quit, "The game is kept; Continue on the title screen goes on with it.")};
}

/// Ways to look at the world, by name: not everybody finds them behind function keys.
std::vector<MenuRow> view_rows(const Settings& settings) {
    struct LookRow {
        Control control;
        const char* hint;
    };
    constexpr LookRow kWays[] = {
        {Control::outside, "The rooms one sees, from outside: in a corner, in full, not at all."},
        {Control::outside_side, "That view from above, or from behind."},
        {Control::fly, "An eye leaves the body and flies, also through walls; again: back."},
        {Control::readout, "Times of pictures, the place, outlines of what is seen through doorways."},
        {Control::pixel, "What is in the middle of the picture: surface, distance, line of the map's file."},
        {Control::automap, "The rooms one has seen, from above."},
        {Control::change_renderer, "The other way to draw the same picture: by the CPU, or by OpenGL."},
        {Control::screenshot, "The picture as a file in your folder for pictures."}};
    std::vector<MenuRow> rows;
    for (const LookRow& way : kWays) {
        MenuRow& row =
            rows.emplace_back(action(std::string(info_of(way.control).label), MenuAction::control, way.hint));
        row.choice.control = way.control;
        row.value = keys_text(keys_for(settings.bindings, way.control));
    }
    return rows;
}

std::string shown_value(const Setting& setting, const Settings& settings) {
    std::string text = setting.text(setting, settings);
    if (setting.name == "true_pitch" && settings.true_pitch && settings.renderer == RendererKind::column)
        return text + ", by stencil only";
    if (setting.name == "frame_limit" && settings.frame_limit == 0) return "as the display";
    if (setting.name == "scale" && settings.size) return text + ", for size window";
    return text;
}

std::vector<MenuRow> option_rows(const Settings& settings) {
    std::vector<MenuRow> rows;
    for (const Setting& setting : all_settings()) {
        MenuRow& row = rows.emplace_back(MenuRow{std::string(setting.label), shown_value(setting, settings)});
        row.hint = std::string(setting.help) + ".";
        row.setting = &setting;
    }
    return rows;
}

std::vector<MenuRow> control_rows(const Settings& settings) {
    std::vector<MenuRow> rows;
    for (int i = 0; i < kControls; ++i) {
        const auto control = static_cast<Control>(i);
        MenuRow& row = rows.emplace_back(
            MenuRow{std::string(info_of(control).label), keys_text(keys_for(settings.bindings, control))});
        row.hint = "Enter: another key for it.  Delete: no key.  Esc: back.";
        row.binding = control;
    }
    return rows;
}

std::vector<MenuRow> help_rows(const Settings& settings) {
    std::vector<MenuRow> rows;
    for (const auto& [keys, what] : key_lines(settings.bindings)) rows.push_back(to_read(what, keys));
    rows.push_back(to_read("Gamepad: walk, look", "left stick, right stick"));
    rows.push_back(to_read("Gamepad: use, crouch, run", "A or X, B, left shoulder"));
    rows.push_back(to_read("Gamepad: menu, map", "Start, Back"));
    rows.push_back(to_read("Maps of your own", "put them into ~/.local/share/enfilade/maps"));
    rows.push_back(to_read("A map's file changed", "it is loaded again while you play"));
    for (MenuRow& row : rows) row.hint = "Esc: back";
    return rows;
}

}  // namespace

std::vector<MenuRow> rows_of(MenuPage page, const Settings& settings, const MenuFacts& facts) {
    switch (page) {
        case MenuPage::title: return title_rows(facts);
        case MenuPage::pause: return pause_rows();
        case MenuPage::views: return view_rows(settings);
        case MenuPage::options: return option_rows(settings);
        case MenuPage::controls: return control_rows(settings);
        case MenuPage::help: return help_rows(settings);
    }
    return {};
}

std::vector<std::pair<std::string, std::string>> key_lines(const Bindings& bindings) {
    const auto keys = [&](Control control) { return keys_text(keys_for(bindings, control)); };
    const auto first = [&](Control control) { return keys_text({keys_for(bindings, control)[0], KeyCode::unknown}); };
    const auto both = [&](Control a, Control b) { return first(a) + "; " + first(b); };
    const std::string walk = fmt::format("{} {} {} {}, mouse", first(Control::forward), first(Control::step_left),
                                         first(Control::back), first(Control::step_right));
    return {{walk, "walk, look around"},
            {both(Control::run, Control::slowly), "run; walk slowly"},
            {keys(Control::crouch), "crouch"},
            {keys(Control::use), "use"},
            {first(Control::automap) + ", wheel", "map; its zoom"},
            {keys(Control::rewind) + ", held", "go back in time"},
            {both(Control::save, Control::load), "save; load"},
            {keys(Control::change_renderer), "column or stencil renderer"},
            {keys(Control::readout), "times, place, viewports"},
            {both(Control::outside, Control::outside_side), "view from outside; its side"},
            {keys(Control::pixel), "what a pixel shows"},
            {keys(Control::fly), "fly through walls; come back"},
            {"Ctrl and wheel", "field of view"},
            {both(Control::fullscreen, Control::screenshot), "full screen; save a picture"},
            {keys(Control::show_keys), "these lines"},
            {"Esc", "menu"}};
}

}  // namespace enfilade
