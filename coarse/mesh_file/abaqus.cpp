#include "coarse/mesh_file/abaqus.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "coarse/mesh_file/abaqus_lines.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Of a set, members: more of them are a mistake in a range, or sets that hold each other again and again.
constexpr std::size_t most_members = 10'000'000;

/// Corners of the elements that are read; 0: of no other.
int corners_of_type(const std::string& type) {
    static const std::map<std::string, int> corners{{"T2D2", 2}, {"T3D2", 2}, {"B21", 2}};
    if (const auto found = corners.find(type); found != corners.end()) return found->second;
    if (!type.starts_with("CPS") && !type.starts_with("CPE")) return 0;
    const std::string rest = type.substr(3);
    // Integration and pressure of their own (R, I, H) are Stria's business.
    const bool first_order = !rest.empty() && rest.find_first_not_of("RIH", 1) == std::string::npos;
    return first_order && rest[0] == '3' ? 3 : first_order && rest[0] == '4' ? 4 : 0;
}

class AbaqusReader {
public:
    AbaqusReader(std::string text, const std::string& name) : lines_(std::move(text), name) {
        part_.format = "Abaqus or CalculiX";
    }

    Part read() {
        Keyword keyword;
        while (lines_.next_keyword(keyword)) {
            if (keyword.word == "*NODE")
                read_nodes(keyword);
            else if (keyword.word == "*ELEMENT")
                read_elements(keyword);
            else if (keyword.word == "*NSET" || keyword.word == "*ELSET")
                read_set(keyword);
            else if (keyword.word == "*SURFACE")
                read_surface(keyword);
            else
                pass_over(keyword);
        }
        name_groups();
        return std::move(part_);
    }

private:
    struct Element {
        std::vector<Number> nodes;
        std::size_t face;  // its place in the part, if it is one
    };
    struct Set {
        std::string name;  // as it is written first
        std::vector<Number> members;
    };
    using Sets = std::map<std::string, Set>;  // by the name in upper case

    void require_data_here(const Keyword& keyword) const {
        if (keyword.parameters.contains("INPUT"))
            lines_.complain(keyword.word +
                            ", INPUT: other files are not read; write the mesh with all its lines in one");
    }

    void read_nodes(const Keyword& keyword) {
        require_data_here(keyword);
        if (!keyword.value("SYSTEM").empty() && upper_case(keyword.value("SYSTEM")) != "R")
            lines_.complain("*NODE, SYSTEM: only Cartesian coordinates are read");
        std::vector<std::string> cells;
        while (lines_.next_data(cells)) {
            if (cells.size() < 3) lines_.complain("a node has a number, x and y");
            const double z = cells.size() > 3 ? lines_.real(cells[3]) : 0.0;
            part_.nodes.push_back({lines_.whole(cells[0]), {lines_.real(cells[1]), lines_.real(cells[2]), z}});
            if (const std::string set = keyword.value("NSET"); !set.empty())
                set_in(node_sets_, set).members.push_back(part_.nodes.back().number);
        }
    }

    void read_elements(const Keyword& keyword) {
        require_data_here(keyword);
        const std::string type = upper_case(keyword.value("TYPE"));
        const int corners = corners_of_type(type);
        std::vector<std::string> cells;
        while (lines_.next_data(cells)) {
            const Number number = lines_.whole(cells[0]);
            if (corners == 0) refuse(type, number);
            while (cells.back().empty()) cells.pop_back();  // number is the first
            if (std::ssize(cells) != corners + 1)
                lines_.complain(fmt::format("element {} of type {} has {} nodes on its line", number, type, corners));
            Element element{{}, part_.faces.size()};
            for (int k = 1; k <= corners; ++k) element.nodes.push_back(lines_.whole(cells[at(k)]));
            if (corners > 2) part_.faces.push_back({number, element.nodes});
            if (!elements_.emplace(number, std::move(element)).second)
                lines_.complain(fmt::format("element {} is given twice", number));
            if (const std::string set = keyword.value("ELSET"); !set.empty())
                set_in(element_sets_, set).members.push_back(number);
        }
    }

    [[noreturn]] void refuse(const std::string& type, Number number) const {
        if (type.starts_with("C3D"))
            lines_.complain(fmt::format("element {} is three-dimensional ({}); Stria reads plane meshes: mesh the "
                                        "cross section",
                                        number, type));
        if (type.starts_with("CPS") || type.starts_with("CPE"))
            lines_.complain(fmt::format("element {} is of second order ({}); Stria reads first order: CPS3, CPS4, "
                                        "CPE3, CPE4",
                                        number, type));
        lines_.complain(fmt::format("element {} is of type {}; CPS3, CPS4, CPE3, CPE4 with R, I or H, and T2D2, T3D2 "
                                    "or B21 for edges are read",
                                    number, type.empty() ? "that *ELEMENT does not say" : type));
    }

    void read_set(const Keyword& keyword) {
        require_data_here(keyword);
        const bool of_nodes = keyword.word == "*NSET";
        Sets& sets = of_nodes ? node_sets_ : element_sets_;
        const std::string name = keyword.value(of_nodes ? "NSET" : "ELSET");
        if (name.empty()) lines_.complain(keyword.word + " has no name");
        std::vector<Number>& members = set_in(sets, name).members;
        if (of_nodes && keyword.parameters.contains("ELSET")) add_nodes_of(keyword.value("ELSET"), name, members);
        std::vector<std::string> cells;
        while (lines_.next_data(cells)) {
            if (keyword.parameters.contains("GENERATE")) {
                generate(cells, name, members);
                continue;
            }
            for (const std::string& cell : cells) {
                if (cell.empty()) continue;
                if (const auto found = sets.find(upper_case(cell)); found != sets.end()) {
                    const std::vector<Number>& others = found->second.members;
                    if (&others == &members) continue;  // what it holds already
                    require_room(name, members.size() + others.size());
                    members.insert(members.end(), others.begin(), others.end());
                } else {
                    members.push_back(lines_.whole(cell));
                }
            }
        }
    }

    void add_nodes_of(const std::string& elements, const std::string& set, std::vector<Number>& members) const {
        const auto found = element_sets_.find(upper_case(elements));
        if (found == element_sets_.end())
            lines_.complain(fmt::format("set {}: there is no set of elements {}", set, elements));
        for (const Number number : found->second.members) {
            const std::vector<Number>& nodes = element_of(number, "set " + set).nodes;
            members.insert(members.end(), nodes.begin(), nodes.end());
        }
    }

    [[nodiscard]] const Element& element_of(Number number, const std::string& group) const {
        const auto found = elements_.find(number);
        if (found == elements_.end()) lines_.complain(fmt::format("{}: there is no element {}", group, number));
        return found->second;
    }

    void require_room(const std::string& set, std::uint64_t members) const {
        if (members > most_members) lines_.complain(fmt::format("set {} has more than {} members", set, most_members));
    }

    void generate(const std::vector<std::string>& cells, const std::string& set, std::vector<Number>& members) const {
        if (cells.size() < 2) lines_.complain("GENERATE needs the first and the last number");
        const Number first = lines_.whole(cells[0]), last = lines_.whole(cells[1]);
        const Number step = cells.size() > 2 && !cells[2].empty() ? lines_.whole(cells[2]) : 1;
        if (step < 1 || last < first) lines_.complain("GENERATE needs an ascending range");
        // Without signs no difference overflows.
        const auto from = static_cast<std::uint64_t>(first), by = static_cast<std::uint64_t>(step);
        const std::uint64_t steps = (static_cast<std::uint64_t>(last) - from) / by;
        require_room(set, members.size() + std::min<std::uint64_t>(steps, most_members) + 1);
        for (std::uint64_t k = 0; k <= steps; ++k) members.push_back(static_cast<Number>(from + k * by));
    }

    /// Faces S1 ... S4 of elements or of sets of them.
    void read_surface(const Keyword& keyword) {
        require_data_here(keyword);
        const std::string type = upper_case(keyword.value("TYPE")), name = keyword.value("NAME");
        if (name.empty()) lines_.complain("*SURFACE has no name");
        if (!type.empty() && type != "ELEMENT") {
            part_.passed_over.insert("*SURFACE, TYPE=" + type);
            return;
        }
        std::vector<std::string> cells;
        while (lines_.next_data(cells)) {
            const auto set = element_sets_.find(upper_case(cells[0]));
            const std::vector<Number> members =
                set != element_sets_.end() ? set->second.members : std::vector{lines_.whole(cells[0])};
            const std::string side = cells.size() > 1 ? upper_case(cells[1]) : "";
            for (const Number member : members) add_side(name, member, side);
        }
    }

    void add_side(const std::string& name, Number number, const std::string& side) {
        const std::vector<Number>& nodes = element_of(number, "surface " + name).nodes;
        const auto k = side.size() == 2 && side[0] == 'S' ? at(side[1] - '1') : nodes.size();
        if (nodes.size() < 3 || k >= nodes.size())
            lines_.complain(fmt::format("surface {}: element {} has no side \"{}\"", name, number, side));
        part_.edges[name].push_back({nodes[k], nodes[(k + 1) % nodes.size()]});
    }

    /// What would change the mesh must not be passed over.
    void pass_over(const Keyword& keyword) {
        for (const char* word : {"*INCLUDE", "*NGEN", "*NFILL", "*NCOPY", "*NMAP", "*ELGEN", "*ELCOPY", "*SYSTEM"})
            if (keyword.word == word)
                lines_.complain(fmt::format("{} is not read; write the mesh with all its nodes and elements", word));
        if (keyword.word == "*PART" && std::exchange(has_part_, true))
            lines_.complain("has more than one *PART; one is read");
        std::vector<std::string> cells;
        if (keyword.word == "*INSTANCE" && lines_.next_data(cells))
            lines_.complain("*INSTANCE moves its part; write the mesh where it lies");
        static const std::vector<std::string> frame{"*HEADING",  "*PART",         "*END PART",    "*ASSEMBLY",
                                                    "*INSTANCE", "*END INSTANCE", "*END ASSEMBLY"};
        if (std::ranges::find(frame, keyword.word) == frame.end()) part_.passed_over.insert(keyword.word);
    }

    static Set& set_in(Sets& sets, const std::string& name) {
        return sets.try_emplace(upper_case(name), Set{name, {}}).first->second;
    }

    void name_groups() {
        for (const auto& [key, set] : node_sets_) part_.node_sets[set.name] = set.members;
        for (const auto& [key, set] : element_sets_) {
            for (const Number member : set.members) {
                const auto found = elements_.find(member);
                if (found == elements_.end()) continue;  // of another part of the model, a spring
                const Element& element = found->second;
                if (element.nodes.size() == 2)
                    part_.edges[set.name].push_back({element.nodes[0], element.nodes[1]});
                else
                    part_.regions[set.name].push_back(element.face);
            }
        }
    }

    AbaqusLines lines_;
    Part part_;
    std::map<Number, Element> elements_;
    Sets node_sets_, element_sets_;
    bool has_part_ = false;
};

}  // namespace

Part read_abaqus(std::string text, const std::string& name) {
    if (text.find('\0') != std::string::npos)  // UTF-16, of which no keyword would be known
        throw CaseError(name + ": is no text of one byte a letter: save it as ASCII or UTF-8");
    return AbaqusReader(std::move(text), name).read();
}

}  // namespace stria::coarse
