// What the export dialog remembers, and what it asks the core for.
#include "ui/export_choice.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ui/export_choice_json.h"
#include "ui/user_settings.h"

namespace planewright::ui {
namespace {

ExportChoice another() {
  ExportChoice choice;
  choice.formats = {ExportFormat::Svg, ExportFormat::ThreeMf};
  choice.dxf = DxfVersion::R12;
  choice.layout = {false, {1500.0, 3000.0}, 4.0, 7.0, false, 20.0, false, true};
  choice.page = PageSize::A1;
  choice.drawn_by = "E. Torroja";
  choice.on_failure = OnFailure::Refuse;
  return choice;
}

TEST(ExportChoice, AtFirstDrawingsAndSchedulesOnStockSheets) {
  const ExportChoice choice;
  EXPECT_EQ(choice.formats, (std::set{ExportFormat::Dxf, ExportFormat::Pdf, ExportFormat::Csv}));
  EXPECT_EQ(choice.on_failure, OnFailure::Mark);
  EXPECT_EQ(choice.page, PageSize::A3);
  EXPECT_TRUE(choice.layout.sheets);
  const ExportSettings settings = export_settings(choice, {}, "roof", "", false);
  ASSERT_TRUE(settings.nesting);
  EXPECT_EQ(settings.nesting->sheet, (SheetSize{3210.0, 6000.0}));
  EXPECT_FALSE(settings.pdf.landscape) << "the sheet stands upright";
  EXPECT_EQ(settings.pdf.page_width, 297.0);
  EXPECT_EQ(settings.pdf.page_height, 420.0);
  EXPECT_FALSE(settings.overwrite);
  EXPECT_EQ(UserSettings().workshop_export, choice);
}

TEST(ExportChoice, IsRememberedWithTheWindowsSettings) {
  UserSettings settings;
  settings.workshop_export = another();
  const auto read = parse_user_settings(format_user_settings(settings));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->workshop_export, another());
}

TEST(ExportChoice, WhatBelongsToOneDesignIsNotRemembered) {
  ExportChoice choice = another();
  choice.project = "Roof of the market";
  choice.note = "second try";
  EXPECT_EQ(read_export_choice(nlohmann::json::parse(to_json(choice).dump())), another());
}

TEST(ExportChoice, DamagedValuesAreAsAtFirst) {
  const auto read = [](const char* text) { return read_export_choice(nlohmann::json::parse(text)); };
  EXPECT_EQ(read("7"), ExportChoice());
  EXPECT_EQ(read(R"({"sheet_width": -3, "spacing": "wide", "page": "B5", "text_height": 1e9})"),
            ExportChoice());
  EXPECT_EQ(read(R"({"formats": ["svg", "dwg", 4]})").formats, std::set{ExportFormat::Svg});
  EXPECT_EQ(read(R"({"formats": ["dwg", null]})"), ExportChoice()) << "none that is known";
  EXPECT_EQ(read(R"({"formats": "svg", "dxf": 12, "sheets": 0, "drawn_by": [], "refuse_failing": "yes"})"),
            ExportChoice());
  EXPECT_TRUE(read(R"({"formats": []})").formats.empty()) << "chosen so";
  const auto settings = parse_user_settings(R"({"workshop_export": [1, 2], "dark": true})");
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->workshop_export, ExportChoice());
}

TEST(ExportChoice, AsksForWhatWasChosen) {
  WorkshopContract contract;
  contract.gap = 8.0;
  contract.tolerances.edge_min = 50.0;
  ExportChoice choice = another();
  choice.layout.sheets = true;
  ExportSettings settings = export_settings(choice, contract, "roof", "2026-02-03", true);
  EXPECT_EQ(settings.formats, std::set{ExportFormat::Svg}) << "solids need a thickness";
  EXPECT_EQ(settings.gap, 8.0);
  EXPECT_EQ(settings.tolerances.edge_min, 50.0);
  EXPECT_EQ(settings.on_failure, OnFailure::Refuse);
  ASSERT_TRUE(settings.nesting);
  EXPECT_EQ(settings.nesting->sheet, (SheetSize{1500.0, 3000.0}));
  EXPECT_FALSE(settings.nesting->rotate);
  EXPECT_TRUE(settings.overwrite);
  EXPECT_EQ(settings.pdf.title.project, "roof");
  EXPECT_EQ(settings.pdf.title.date, "2026-02-03");
  contract.thickness = 20.0;
  choice.layout.sheets = false;
  settings = export_settings(choice, contract, "roof", "", false);
  EXPECT_EQ(settings.formats.size(), 2u);
  EXPECT_FALSE(settings.nesting);
}

}  // namespace
}  // namespace planewright::ui
