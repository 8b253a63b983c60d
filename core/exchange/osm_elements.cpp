// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/osm_elements.h"

#include <cpl_vsi.h>
#include <expat.h>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <type_traits>

#include "core/exchange/source_features.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

template <typename Number>
std::optional<Number> number_from(const char* text) {
  if (text == nullptr) return std::nullopt;
  const std::string_view view(text);
  Number value{};
  const auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), value);
  if (error != std::errc() || end != view.data() + view.size()) return std::nullopt;
  return value;
}

/// The attributes of an element, as expat gives them.
class Attributes {
 public:
  explicit Attributes(const XML_Char** pairs) : pairs_(pairs) {}
  [[nodiscard]] const char* operator[](std::string_view name) const {
    for (const XML_Char** pair = pairs_; *pair != nullptr; pair += 2) {
      if (name == pair[0]) return pair[1];
    }
    return nullptr;
  }
  [[nodiscard]] std::string text(std::string_view name) const {
    const char* const value = (*this)[name];
    return value != nullptr ? value : "";
  }

 private:
  const XML_Char** pairs_;
};

std::optional<Eigen::Vector2d> place_of(const Attributes& given,
                                        std::string_view longitude,
                                        std::string_view latitude) {
  const auto lon = number_from<double>(given[longitude]);
  const auto lat = number_from<double>(given[latitude]);
  if (!lon || !lat || !(std::abs(*lon) <= 180.0) || !(std::abs(*lat) <= 90.0)) return std::nullopt;
  return Eigen::Vector2d(*lon, *lat);
}

bool is_deleted(const Attributes& given) {
  return given.text("action") == "delete" || given.text("visible") == "false";
}

/// Collects elements while expat reads.
class OsmParser {
 public:
  explicit OsmParser(std::string name)
      : name_(std::move(name)), parser_(XML_ParserCreate(nullptr)) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), begin_element, end_element);
    // OpenStreetMap's files have none, and what one can say makes small files endless.
    XML_SetStartDoctypeDeclHandler(
        parser_.get(), [](void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
          auto& parser = *static_cast<OsmParser*>(self);
          XML_StopParser(parser.parser_.get(), XML_FALSE);
        });
  }

  /// @errors kMalformed.
  Result<void> take(std::string_view bytes, bool is_last) {
    if (XML_Parse(parser_.get(), bytes.data(), static_cast<int>(bytes.size()),
                  is_last ? XML_TRUE : XML_FALSE) == XML_STATUS_OK) {
      return {};
    }
    return fail(ErrorCode::kMalformed, "{}: is no whole OpenStreetMap XML (line {}: {})", name_,
                XML_GetCurrentLineNumber(parser_.get()),
                XML_ErrorString(XML_GetErrorCode(parser_.get())));
  }

  /// @errors kMalformed: it was some other XML.
  Result<OsmElements> elements() && {
    if (is_osm_) return std::move(found_);
    return fail(ErrorCode::kMalformed, "{}: is no OpenStreetMap XML, which begins with <osm>",
                name_);
  }

 private:
  static void begin_element(void* self, const XML_Char* name, const XML_Char** attributes) {
    static_cast<OsmParser*>(self)->begin(name, Attributes(attributes));
  }
  static void end_element(void* self, const XML_Char* name) {
    static_cast<OsmParser*>(self)->end(name);
  }

  void begin(std::string_view element, const Attributes& given) {
    if (depth_++ == 0) is_osm_ = element == "osm";
    if (element == "node" || element == "way" || element == "relation") {
      begin_thing(element, given);
    } else if (element == "bounds") {
      const auto low = place_of(given, "minlon", "minlat");
      const auto high = place_of(given, "maxlon", "maxlat");
      if (!low || !high || !(low->x() < high->x()) || !(low->y() < high->y())) return;
      if (!found_.bounds_deg) found_.bounds_deg.emplace();
      found_.bounds_deg->include(*low);
      found_.bounds_deg->include(*high);
    } else if (is_open_ && element == "tag") {
      tags_[given.text("k")] = given.text("v");
    } else if (is_open_ && element == "nd") {
      if (const auto id = number_from<std::int64_t>(given["ref"])) nodes_.push_back(*id);
    } else if (is_open_ && element == "member") {
      add_member(given);
    }
  }

  void begin_thing(std::string_view element, const Attributes& given) {
    is_open_ = false;
    if (is_deleted(given)) return;
    const auto id = number_from<std::int64_t>(given["id"]);
    const auto place = element == "node" ? place_of(given, "lon", "lat") : std::nullopt;
    if (!id || (element == "node" && !place)) {
      ++found_.unsound;
      return;
    }
    if (place) found_.nodes[*id] = *place;
    id_ = *id;
    tags_.clear();
    nodes_.clear();
    members_.clear();
    is_open_ = true;
  }

  void add_member(const Attributes& given) {
    const auto id = number_from<std::int64_t>(given["ref"]);
    const std::string type = given.text("type");
    if (!id || (type != "node" && type != "way" && type != "relation")) return;
    members_.push_back({type == "way"    ? OsmMember::Type::kWay
                        : type == "node" ? OsmMember::Type::kNode
                                         : OsmMember::Type::kRelation,
                        *id, given.text("role")});
  }

  void end(std::string_view element) {
    --depth_;
    if (!is_open_) return;
    if (element == "node") {
      if (!tags_.empty()) found_.tagged_nodes.emplace_back(id_, std::move(tags_));
    } else if (element == "way") {
      found_.ways.push_back({id_, std::move(nodes_), std::move(tags_)});
    } else if (element == "relation") {
      found_.relations.push_back({id_, std::move(members_), std::move(tags_)});
    } else {
      return;
    }
    is_open_ = false;
  }

  struct Freed {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };
  std::string name_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Freed> parser_;
  OsmElements found_;
  int depth_ = 0;
  bool is_osm_ = false;
  bool is_open_ = false;  ///< Within a node, way or relation that is taken.
  std::int64_t id_ = 0;
  ImportTags tags_;
  std::vector<std::int64_t> nodes_;
  std::vector<OsmMember> members_;
};

struct FileCloser {
  void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};
using File = std::unique_ptr<VSILFILE, FileCloser>;

/// Unpacks what gzip has packed.
File open_source(const fs::path& path) {
  std::array<unsigned char, 2> begin{};
  File file(VSIFOpenL(path.c_str(), "rb"));
  if (file == nullptr) return file;
  VSIFReadL(begin.data(), 1, begin.size(), file.get());
  if (begin == std::array<unsigned char, 2>{0x1F, 0x8B}) {
    return File(VSIFOpenL(("/vsigzip/" + path.string()).c_str(), "rb"));
  }
  VSIFSeekL(file.get(), 0, SEEK_SET);
  return file;
}

}  // namespace

bool looks_like_osm_xml(const fs::path& path) {
  const File file = open_source(path);
  if (file == nullptr) return false;
  std::string begin(4096, '\0');
  begin.resize(VSIFReadL(begin.data(), 1, begin.size(), file.get()));
  return begin.find("<osm") != std::string::npos;
}

Result<OsmElements> parse_osm_elements(std::string_view text, const std::string& name) {
  OsmParser parser(name);
  if (const auto taken = parser.take(text, true); !taken) return forward_error(taken);
  return std::move(parser).elements();
}

Result<OsmElements> read_osm_elements(const fs::path& path, const WorkContext& context) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return fail(ErrorCode::kNotFound, "{}: no such file", path.string());
  }
  const double size = std::max(1.0, static_cast<double>(fs::file_size(path, error)));
  const File file = open_source(path);
  if (file == nullptr) return fail(ErrorCode::kIo, "{}: cannot be opened", path.string());
  OsmParser parser(path.string());
  std::string bytes(std::size_t{1} << 20U, '\0');
  double read = 0.0;
  for (bool is_last = false; !is_last;) {
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "{}: cancelled", path.string());
    const std::size_t count = VSIFReadL(bytes.data(), 1, bytes.size(), file.get());
    is_last = count < bytes.size();
    const auto taken = parser.take(std::string_view(bytes.data(), count), is_last);
    if (!taken) return forward_error(taken);
    read += static_cast<double>(count);
    context.report(std::min(1.0, read / size), "reading");
  }
  return std::move(parser).elements();
}

}  // namespace nadir
