#include "deadpoint/machine/cad/step_solids.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/machine/cad/step_names.hpp"
#include <BRepBuilderAPI_Transform.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string_view>

namespace deadpoint::machine {
namespace {

std::string lower(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Length of a unit by the name that Open CASCADE reports [m]; 0: unknown.
double length_of(const std::string& name)
{
    constexpr std::array<std::pair<std::string_view, double>, 9> units{{{"millimetre", 1e-3},
                                                                        {"centimetre", 1e-2},
                                                                        {"decimetre", 1e-1},
                                                                        {"micrometre", 1e-6},
                                                                        {"kilometre", 1e3},
                                                                        {"metre", 1},
                                                                        {"inch", 0.0254},
                                                                        {"foot", 0.3048},
                                                                        {"mil", 25.4e-6}}};
    const std::string small = lower(name);
    const auto* found = std::ranges::find_if(units, [&](const auto& unit) { return small == unit.first; });
    return found == units.end() ? 0 : found->second;
}

std::string name_of(const TDF_Label& label, StepLetters letters)
{
    Handle(TDataStd_Name) name;
    if (label.IsNull() || !label.FindAttribute(TDataStd_Name::GetID(), name)) {
        return {};
    }
    return step_name(name->Get(), letters);
}

std::string hex(const Quantity_Color& colour)
{
    const auto byte = [](double share) { return static_cast<int>(share * 255 + 0.5); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.Red()), byte(colour.Green()), byte(colour.Blue()));
}

/// Walks through the products of a document.
class Walk {
public:
    Walk(const Handle(TDocStd_Document) & document, Handle(XSControl_WorkSession) session, StepLetters letters,
         StepContents& into)
        : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
          colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())), session_(std::move(session)), letters_(letters),
          into_(into)
    {}

    void all()
    {
        TDF_LabelSequence roots;
        shapes_->GetFreeShapes(roots);
        for (int i = 1; i <= roots.Length(); ++i) {
            visit(roots.Value(i), TopLoc_Location(), "", "", "");
        }
    }

private:
    void visit(const TDF_Label& label, const TopLoc_Location& place, const std::string& path, const std::string& better,
               std::string colour)
    {
        TDF_Label product = label;
        TopLoc_Location here = place;
        colour = colour_of(label, colour);
        if (XCAFDoc_ShapeTool::IsReference(label)) {
            XCAFDoc_ShapeTool::GetReferredShape(label, product);
            here = place * XCAFDoc_ShapeTool::GetLocation(label);
        }
        std::string own = name_of(product, letters_);
        const std::string occurrence = name_of(label, letters_);
        own = says_nothing(own) ? (says_nothing(occurrence) ? better : occurrence) : own;
        if (!XCAFDoc_ShapeTool::IsAssembly(product)) {
            take(product, here, path, own, colour_of(product, colour));
            return;
        }
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(product, components);
        for (int i = 1; i <= components.Length(); ++i) {
            visit(components.Value(i), here, path.empty() ? own : path + "/" + own, own, colour);
        }
    }

    std::string colour_of(const TDF_Label& label, const std::string& otherwise) const
    {
        Quantity_Color colour;
        for (const auto type : {XCAFDoc_ColorGen, XCAFDoc_ColorSurf}) {
            if (colours_->GetColor(label, type, colour)) {
                return hex(colour);
            }
        }
        return otherwise;
    }

    void take(const TDF_Label& product, const TopLoc_Location& place, const std::string& path, const std::string& name,
              const std::string& colour)
    {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
        bool any = false;
        for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
            any = true;
            const std::string inner = item_name(solid.Current());
            const std::string called = says_nothing(name) ? (says_nothing(inner) ? "" : inner) : name;
            StepSolid one{called, unique(key_of(called)), path, colour, solid.Current().Moved(place), {}};
            name_faces(solid.Current(), place, one);
            into_.solids.push_back(std::move(one));
        }
        if (!any) {
            into_.without_solid.push_back(name.empty() ? "(no name)" : name);
        }
    }

    void name_faces(const TopoDS_Shape& solid, const TopLoc_Location& place, StepSolid& into) const
    {
        for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
            if (const auto name = item_name(face.Current()); !name.empty() && name != "NONE") {
                into.named_faces.push_back({TopoDS::Face(face.Current().Moved(place)), name});
            }
        }
    }

    /// The name of the entity of the file that became the shape.
    std::string item_name(const TopoDS_Shape& shape) const
    {
        const auto entity = session_->TransferReader()->EntityFromShapeResult(shape, 1);
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
        return item.IsNull() || item->Name().IsNull()
                   ? std::string()
                   : step_name(TCollection_ExtendedString(item->Name()->ToCString(), true), letters_);
    }

    std::string unique(const std::string& name)
    {
        std::string result = name;
        for (int n = 2; !names_.insert(result).second; ++n) {
            result = fmt::format("{}_{}", name, n);
        }
        return result;
    }

    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
    Handle(XSControl_WorkSession) session_;
    StepLetters letters_;
    StepContents& into_;
    std::set<std::string> names_;
};

std::string unit_of(STEPControl_Reader& reader)
{
    TColStd_SequenceOfAsciiString lengths;
    TColStd_SequenceOfAsciiString angles;
    TColStd_SequenceOfAsciiString solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    return lengths.IsEmpty() ? std::string() : lower(lengths.First().ToCString());
}

void enlarge(StepContents& contents)
{
    gp_Trsf larger;
    larger.SetScale(gp_Pnt(0, 0, 0), contents.scale);
    for (StepSolid& solid : contents.solids) {
        BRepBuilderAPI_Transform made(solid.shape, larger, true);
        for (NamedFace& named : solid.named_faces) {
            named.face = TopoDS::Face(made.ModifiedShape(named.face));
        }
        solid.shape = made.Shape();
    }
}

/// What the user's unit is to the file's.
double scale_of(const ForeignFile& file, const std::string& unit, std::optional<double> stated)
{
    if (!stated) {
        return 1;
    }
    const double own = unit.empty() ? 1e-3 : length_of(unit);
    if (own == 0) {
        throw InputError(
            fmt::format("part '{}': '{}' has the unit '{}', which is not known\n  help: export it in millimetres",
                        file.part, file.path, unit));
    }
    return *stated / own;
}

}  // namespace

InputError unreadable(const ForeignFile& file)
{
    return InputError(
        fmt::format("part '{}': '{}' cannot be read: its contents are incomplete or out of order\n  help: check "
                    "the file with the program that wrote it, and write it again",
                    file.part, file.path));
}

StepContents read_step_solids(const ForeignFile& file, StepLetters letters, std::optional<double> unit)
{
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    STEPCAFControl_Reader reader;
    Interface_Static::SetCVal("read.step.codepage", code_page(letters));
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    if (reader.ReadFile(file.name.c_str()) != IFSelect_RetDone || !reader.Transfer(document)) {
        throw unreadable(file);
    }
    StepContents contents;
    contents.unit = unit_of(reader.ChangeReader());
    contents.scale = scale_of(file, contents.unit, unit);
    Walk(document, reader.ChangeReader().WS(), letters, contents).all();
    if (contents.scale != 1) {
        enlarge(contents);
    }
    return contents;
}

}  // namespace deadpoint::machine
