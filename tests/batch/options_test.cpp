#include "batch/batch_folder.hpp"

#include <planish/batch/options.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

constexpr auto kGauges = R"("gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}])";

class BatchOptionsOf : public test::BatchFolder {
 protected:
  BatchOptionsOf() {
    write("two.json", std::string(R"({"name": "S", "materials": [{"name": "Steel", )") + kGauges +
                          R"(}, {"name": "brass", )" + kGauges + "}]}");
    write("list.csv", "part,material,quantity\na,Steel,3\n");
    write("no-quantity.csv", "part,material\nleg*,Steel\n");
    write("exact.csv", "part,material\na,Steel\n");
    write("oak.csv", "part,material\na,oak\n");
    write("plain.step", "ISO-10303-21; DATA; ENDSEC;");
    write("leg_2.step", "ISO-10303-21; DATA; ENDSEC;");
    write("body.step", "#1 = MANIFOLD_SOLID_BREP('Leg',#2);");
    write("named.step", "#1 = DESCRIPTIVE_REPRESENTATION_ITEM('STEEL','');");
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  Input input(const std::string& name) const { return {at(name), name}; }
  /// The place of what is wrong; empty if nothing is.
  std::string wrong(const std::vector<Input>& inputs, const nlohmann::json& options) const {
    const auto error = useless_options(inputs, options.dump(), job::built_in());
    if (!error) return "";
    EXPECT_EQ(error->code, code::bad_option) << error->message;
    return error->where;
  }
};

TEST_F(BatchOptionsOf, ChooseAmongTheMaterialsOfAShop) {
  const nlohmann::json shop{{"shop", at("two.json")}};
  EXPECT_EQ(wrong({input("plain.step")}, shop), "material") << "nobody chooses";
  EXPECT_EQ(wrong({input("plain.step"), input("named.step")}, shop), "") << "a file does";
  auto chosen = shop;
  chosen["material"] = "brass";
  EXPECT_EQ(wrong({input("plain.step")}, chosen), "");
  chosen = shop;
  chosen["materials"] = at("no-quantity.csv");
  EXPECT_EQ(wrong({input("leg_2.step")}, chosen), "") << "the list does";
  EXPECT_EQ(wrong({input("leg_2.step"), input("plain.step")}, chosen), "materials") << "not of all";
  EXPECT_EQ(wrong({input("leg_2.step"), input("named.step")}, chosen), "");
  EXPECT_EQ(wrong({input("body.step")}, chosen), "") << "a body in it may be meant";
  chosen["materials"] = at("exact.csv");
  EXPECT_EQ(wrong({input("plain.step")}, chosen), "materials") << "no body has that name";
  write("files.csv", "part,material\nplain.step,Steel\n");
  chosen["materials"] = at("files.csv");
  EXPECT_EQ(wrong({input("plain.step")}, chosen), "") << "a row may name the file";
  EXPECT_EQ(wrong({input("plain.step"), input("leg_2.step")}, chosen), "materials");
  chosen["materials"] = at("oak.csv");
  EXPECT_EQ(wrong({input("plain.step")}, chosen), "materials") << "the shop has no oak";
  EXPECT_EQ(wrong({input("plain.step")}, {{"k", 0.4}}), "");
}

TEST_F(BatchOptionsOf, OrderPiecesOfSomePartAtLeast) {
  write("legs.csv", "part,material,quantity\nleg*,Steel,\nseat,Steel,4\n");
  EXPECT_EQ(wrong({input("plain.step")}, {{"materials", at("list.csv")}}), "materials");
  EXPECT_EQ(wrong({input("plain.step")}, {{"materials", at("exact.csv")}}), "") << "no order";
  const nlohmann::json legs{{"materials", at("legs.csv")}};
  EXPECT_EQ(wrong({input("plain.step"), input("leg_2.step")}, legs), "");
  EXPECT_EQ(wrong({input("body.step")}, legs), "") << "a body in it may be meant";
}

TEST_F(BatchOptionsOf, GiveQuantitiesInOnePlace) {
  Input counted = input("plain.step");
  counted.copies = 20;
  counted.said_by = "parts.txt, line 1";
  EXPECT_EQ(wrong({counted}, {{"materials", at("list.csv")}}), "materials");
  EXPECT_EQ(wrong({counted}, {{"materials", at("no-quantity.csv")}}), "");
  write("a.step", "ISO-10303-21; DATA; ENDSEC;");
  EXPECT_EQ(wrong({input("a.step")}, {{"materials", at("list.csv")}}), "");
}

TEST_F(BatchOptionsOf, MakeARequestOfAllMakers) {
  const auto request = request_of(R"({"rip_edges": "3", "inside_radius": 4, "k": 0.3})",
                                  job::built_in());
  ASSERT_TRUE(request) << request.error().message;
  EXPECT_EQ(request->rip_edges, std::vector<int>{3}) << "of unfold";
  EXPECT_EQ(request->join.inside_radius, 4.0) << "of connect";
  EXPECT_TRUE(request->allowance);
  EXPECT_FALSE(request_of(R"({"k": 0.3, "din6935": true})", job::built_in()));
}

}  // namespace
}  // namespace planish::batch
