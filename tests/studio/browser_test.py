#!/usr/bin/python3
"""The page in a browser without a window, from opening a file to a downloaded DXF (web/test/browser.mjs)."""

import csv
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

import ezdxf

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent / "../cli"))
import step_files  # noqa: E402
from planish_studio import CLI, EXAMPLES, SOURCE, StudioTest, main  # noqa: E402

SECONDS_OF_FLOWS = 1100


def flows(studio, folder, *names):
    """What the flows of these names say, or all that need no studio of their own."""
    done = subprocess.run(["node", "test/browser.mjs", f"http://127.0.0.1:{studio.port}/#{studio.token}", *names], cwd=SOURCE / "web",
                          capture_output=True, text=True, timeout=SECONDS_OF_FLOWS,
                          env=dict(os.environ, STUDIO_FILES=str(folder), STUDIO_PROCESS=str(studio.process.pid)))
    return done.stdout + done.stderr


class Given(StudioTest):
    arguments = (EXAMPLES / "bracket.step",)

    def test_a_reload_keeps_the_edits_of_a_file_named_on_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertRegex(flows(self.studio, folder, "given"), r"(?m)^ok given\b")


class Browser(StudioTest):
    @classmethod
    def setUpClass(cls):
        """All flows run one after the other in one browser."""
        super().setUpClass()
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        (cls.folder / "pressed.step").write_text(step_files.pressed_plate())
        (cls.folder / "thousand.step").write_text(step_files.thousand_openings())
        (cls.folder / "channel.step").write_text(step_files.perforated_channel(100, 40, 2, 3, 160, [(20, 20), (80, 65)], 5))
        (cls.folder / "wide.step").write_text(step_files.perforated_channel(60, 20, 2, 3, 600, [(300, 30)], 5))
        (cls.folder / "small.step").write_text(step_files.perforated_channel(60, 20, 2, 3, 600, [(8, 30)], 2.5))
        (cls.folder / "lanced.step").write_text(step_files.lanced())
        (cls.folder / "tube.step").write_text(step_files.square_tube())
        (cls.folder / "curled.step").write_text(step_files.curled())
        (cls.folder / "stepped.step").write_text(step_files.stepped_angle())
        (cls.folder / "short.step").write_text(step_files.two_angles_one_short())
        (cls.folder / "sixty.step").write_text(step_files.assembly_of_sixty())
        cls.said = flows(cls.studio, cls.folder)

    def flow(self, name):
        """What the flows say, once this one went well."""
        if not re.search(rf"(?m)^ok {name}\b", self.said):
            failed = re.search(rf"(?ms)^not ok {name}:.*?(?=^(?:not )?ok |\Z)", self.said)
            self.fail(failed[0] if failed else self.said)
        return self.said

    def drawing(self, name):
        """The DXF that a flow downloads at its end."""
        self.flow(name)
        (path,) = (self.folder / name).glob("*.dxf")
        drawing = ezdxf.readfile(path)
        self.assertFalse(drawing.audit().has_errors)
        return drawing

    def test_unfold(self):
        layers = {entity.dxf.layer for entity in self.drawing("unfold").modelspace()}
        self.assertEqual(layers, {"OUTER_PROFILE", "INTERIOR_PROFILES", "BEND_UP"})

    def test_connect(self):
        layers = [entity.dxf.layer for entity in self.drawing("connect").modelspace()]
        self.assertEqual(layers.count("OUTER_PROFILE"), 1)
        self.assertIn("BEND_UP", layers)

    def test_transition(self):
        layers = [entity.dxf.layer for entity in self.drawing("transition").modelspace()]
        self.assertEqual(layers.count("OUTER_PROFILE"), 1)
        self.assertIn("BEND_UP", layers)

    def test_slit(self):
        layers = [entity.dxf.layer for entity in self.drawing("slit").modelspace()]
        self.assertEqual(layers.count("OUTER_PROFILE"), 1)
        self.assertIn("BEND_UP", layers)

    def test_strokes_are_shown_in_the_machine(self):
        self.flow("order")

    def test_a_stroke_is_moved_and_what_collides_is_red(self):
        self.flow("reorder")

    def test_an_order_is_there_after_a_reload_and_can_be_undone(self):
        self.flow("orderkept")

    def test_what_a_refusal_names_is_seen_in_the_part(self):
        self.flow("refusal")

    def test_a_refused_part_offers_only_what_can_be_had(self):
        self.flow("offered")

    def test_reliefs_that_a_finding_names_are_cut_by_one_click(self):
        self.flow("reliefs")

    def test_what_is_refused_has_the_room(self):
        self.flow("roomy")

    def test_what_cannot_be_planned_is_said(self):
        self.flow("unplanned")

    def test_edges_are_picked(self):
        self.flow("edges")

    def test_a_root_is_picked_in_the_flat_pattern(self):
        self.flow("picks")

    def test_surfaces_drop_what_does_not_go_with_them(self):
        self.flow("surfaces")

    def test_every_profile_can_take_the_place_of_another(self):
        self.flow("profiles")

    def test_one_of_ten_plates_is_dragged(self):
        self.flow("ten")

    def test_plates_come_and_go(self):
        layers = [entity.dxf.layer for entity in self.drawing("plates").modelspace()]
        self.assertEqual(layers.count("OUTER_PROFILE"), 1)

    def test_strips_of_their_own_widths(self):
        self.flow("strips")

    def test_slits_are_curves(self):
        self.flow("curves")

    def test_outlines_are_dragged(self):
        self.flow("outline")

    def test_panels_lean(self):
        self.flow("leaning")

    def test_leg_curves_are_scaled_to_the_sheet(self):
        self.flow("fitted")

    def test_a_second_panel_comes_and_goes(self):
        self.flow("second")

    def test_the_mould_is_made_as_its_fields_say(self):
        self.flow("mould")

    def test_control_points_by_number(self):
        self.flow("points")

    def test_inches_are_those_of_the_command_line(self):
        said = self.flow("inch")
        blank = re.search(r"blank ([\d.]+) × ([\d.]+) of", said)
        done = subprocess.run([CLI, "unfold", self.folder / "inch" / "inch.step", "--units", "inch", "--check", "--json", "-", "--quiet"], capture_output=True, text=True, timeout=60)
        for shown, size in zip(blank.groups(), json.loads(done.stdout)["flat"]["size"]):
            self.assertAlmostEqual(float(shown), size, delta=5e-4)

    def test_a_file_is_dropped_and_its_overlap_is_red(self):
        self.flow("drop")

    def test_a_plate_is_turned_by_its_ring(self):
        self.flow("turn")

    def test_invalid_input_leaves_the_last_shape(self):
        self.flow("invalid")

    def test_scans_are_aligned(self):
        self.flow("scan")

    def test_long_work_is_given_up_and_nothing_jumps(self):
        self.flow("long")

    def test_nothing_is_cut_off(self):
        self.flow("layout")

    def test_circles_are_drawn_to_a_quarter_of_a_pixel_and_say_their_diameter(self):
        self.flow("circle")

    def test_the_first_picture_is_that_of_the_part(self):
        self.flow("first")

    def test_a_thousand_openings_are_orbited_folded_and_hovered(self):
        self.flow("thousand")

    def test_what_is_under_the_pointer_lights_up_in_both_views(self):
        self.flow("hover")

    def test_the_pattern_is_measured(self):
        self.flow("measure")

    def test_the_rim_of_a_small_hole_is_taken_where_the_pointer_is_on_it(self):
        self.flow("rims")

    def test_the_folded_part_is_measured(self):
        self.flow("measurefolded")

    def test_many_measures_leave_most_of_the_part_to_be_seen(self):
        self.flow("manymeasures")

    def test_one_measures_by_keys_alone(self):
        self.flow("measurekeys")

    def test_a_section_shows_the_thickness_and_glass_what_is_behind(self):
        self.flow("section")

    def test_the_cube_shows_and_chooses_from_where_one_looks(self):
        self.flow("cube")

    def test_the_views_share_the_room_as_they_are_dragged(self):
        self.flow("split")

    def test_nothing_lies_over_a_button_of_a_narrow_view(self):
        self.flow("narrow")

    def test_what_is_drawn_is_told_from_what_is_cut(self):
        self.flow("forms")

    def test_an_assembly_opens_on_its_first_sheet_and_the_list_says_what_became_of_each_body(self):
        self.flow("assembly")

    def test_what_is_edited_can_be_opened_again_after_another_file_took_its_place(self):
        self.flow("leaving")

    def test_one_goes_back_to_the_start_page(self):
        self.flow("startpage")

    def test_a_reload_keeps_the_tab(self):
        self.flow("tabkept")

    def test_files_that_are_not_opened_are_said(self):
        self.flow("besides")

    def test_small_windows_reach_all_of_the_page(self):
        self.flow("small")

    def test_small_windows_show_the_machine_and_what_collides(self):
        self.flow("smallmachine")

    def test_values_that_cannot_be_are_refused_with_a_sentence(self):
        self.flow("refused")

    def test_the_dxf_says_its_unit(self):
        self.flow("dxfunit")

    def test_a_dxf_is_written_as_the_panel_says(self):
        self.flow("dxfpanel")
        (path,) = (self.folder / "dxfpanel").glob("*.dxf")
        subprocess.run([CLI, "unfold", EXAMPLES / "bracket.step", "--units", "inch", "--r12", "--profile", "onshape", "--bend-marks", "ticks", "--tick-length", "3",
                        "--arc-tolerance", "0.02", "--tangent-lines", "--bend-text", "--turn-to-blank", "--quiet", "-o", self.folder / "wanted.dxf"], check=True, timeout=60)
        self.assertEqual(path.read_bytes(), (self.folder / "wanted.dxf").read_bytes())

    def test_bodies_are_listed_and_downloaded_at_once(self):
        """The archive holds what `unfold --all` writes, its summary rounded."""
        self.flow("bodies")
        with zipfile.ZipFile(self.folder / "bodies" / "sixty.zip") as archive:
            self.assertIsNone(archive.testzip())
            made = {name: archive.read(name) for name in archive.namelist()}
        wanted = self.folder / "all"
        wanted.mkdir()
        subprocess.run([CLI, "unfold", self.folder / "sixty.step", "--all", "--din6935", "--quiet", "-o", "."], cwd=wanted, check=True, timeout=120)
        self.assertEqual(sorted(made), sorted(path.name for path in wanted.iterdir() if path.name != "summary.json"))
        self.assertEqual(len(made), 52)
        for name, content in made.items():
            if name != "summary.csv":
                self.assertEqual(content.decode(), (wanted / name).read_text(), name)
        self.same_summary(made["summary.csv"].decode(), (wanted / "summary.csv").read_text())

    def same_summary(self, made, wanted):
        """The program's figures, rounded as the page shows them, and pierces."""
        made, wanted = (list(csv.DictReader(io.StringIO(text, newline=""))) for text in (made, wanted))
        self.assertEqual(list(made[0]), [name for known in wanted[0] for name in ([known, "pierces"] if known == "openings" else [known])])
        self.assertEqual(len(made), len(wanted))
        decimals = {"thickness": 3, "volume_ratio": 6} | dict.fromkeys(("length", "width", "outer_cutting", "inner_cutting"), 2)
        for own, row in zip(made, wanted):
            for name, value in row.items():
                if name in decimals and value:
                    self.assertAlmostEqual(float(own[name]), float(value), delta=0.501 * 10 ** -decimals[name] + 6e-6 * float(value), msg=name)
                    self.assertLessEqual(len(own[name].partition(".")[2]), decimals[name], name)
                elif name == "area" and value:
                    self.assertAlmostEqual(float(own[name]) / float(value), 1, delta=5e-4)
                elif name in ("length_error", "refold_deviation") and value:
                    self.assertAlmostEqual(float(own[name]), float(value), delta=max(float(value) / 2, 1e-9), msg=name)
                else:
                    self.assertEqual(own[name], value.replace("./", ""), name)
            self.assertEqual(own["pierces"], "1" if row["files"] else "", row["body"])

    def test_a_body_has_one_status_before_and_after_it_is_opened(self):
        self.flow("status")

    def test_the_list_shows_the_body_that_is_chosen(self):
        self.flow("listed")

    def test_long_names_of_bodies_are_cut_in_the_middle(self):
        self.flow("longnames")

    def test_what_has_no_pattern_has_a_picture_of_its_solid(self):
        self.flow("solids")

    def test_a_shop_says_k_and_mass(self):
        self.flow("allowance")
        (path,) = (self.folder / "allowance").glob("*-report.json")
        done = subprocess.run([CLI, "unfold", EXAMPLES / "bracket.step", "--shop", EXAMPLES / "shop" / "example.json", "--material", "mild steel", "--check", "--json", "-", "--quiet"],
                              capture_output=True, text=True, timeout=60)
        wanted, made = json.loads(done.stdout), json.loads(path.read_text())
        for key in ("sheet", "flat", "checks"):
            self.assertEqual(made[key], wanted[key])
        self.assertGreater(made["sheet"]["mass"], 0)

    def test_the_table_says_what_a_deduction_is_measured_to(self):
        self.flow("deductions")

    def test_a_bend_table_and_outside_lengths(self):
        self.flow("bendtable")

    def test_what_was_dragged_is_there_after_a_reload(self):
        self.flow("reload")

    def test_bends_keep_their_names_and_the_pattern_its_way_while_plates_move(self):
        self.flow("steady")

    def test_the_chosen_bend_stays_chosen_when_bends_are_numbered_anew(self):
        self.flow("chosen")

    def test_a_rule_has_one_mark_until_it_is_chosen(self):
        self.flow("marks")

    def test_every_state_of_the_page_is_for_everyone(self):
        self.flow("access")

    def test_both_views_are_for_everyone_while_one_measures_and_cuts(self):
        self.flow("viewstates")

    def test_lists_and_refusals_are_for_everyone(self):
        self.flow("liststates")

    def test_the_machine_is_for_everyone(self):
        self.flow("machinestates")

    def test_panels_are_for_everyone_with_all_that_they_unfold(self):
        self.flow("panelstates")

    def test_a_new_file_of_each_kind_can_be_begun(self):
        self.flow("begin")

    def test_files_opened_lately_are_there_again(self):
        self.flow("recent")

    def test_pages_that_are_open_at_once_share_what_is_kept(self):
        self.flow("pages")

    def test_undo_in_a_field_is_that_of_the_page_once_it_is_entered(self):
        self.flow("undofield")

    def test_what_is_typed_is_entered_whatever_is_dragged_next(self):
        self.flow("typed")

    def test_a_drag_can_be_given_up(self):
        self.flow("giveup")

    def test_the_space_bar_and_the_focus(self):
        self.flow("spacebar")

    def test_large_files_survive_a_reload_and_long_lists_are_kept(self):
        self.flow("large")

    def test_the_last_eight_files_are_kept(self):
        self.flow("many")

    def test_the_page_works_under_its_policy(self):
        self.flow("policy")

    def test_rubbish_is_answered_with_the_programs_sentence(self):
        said = self.flow("rubbish")
        self.assertIn("STEP", said)

    def test_a_file_that_is_being_opened_can_be_given_up(self):
        self.flow("opening")

    def test_a_killed_worker_is_said_and_work_goes_on(self):
        self.flow("killed")

    def test_two_pages_at_once(self):
        self.flow("two")


if __name__ == "__main__":
    main()
