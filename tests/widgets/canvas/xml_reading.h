// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include <map>
#include <string>
#include <vector>

namespace nadir {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;    ///< Of itself, without its children's; entities are letters again.
  std::string parent;  ///< Name of the element around it.
  int depth = 0;       ///< 0 for the root.

  [[nodiscard]] std::string operator[](const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? "(none)" : found->second;
  }
};

/// Elements of an XML text in their order, read by Expat, which accepts nothing that is not well-formed.
class XmlReading : public vtkXMLParser {
 public:
  static XmlReading* New();
  vtkTypeMacro(XmlReading, vtkXMLParser) XmlReading(const XmlReading&) = delete;
  XmlReading& operator=(const XmlReading&) = delete;

  std::vector<XmlElement> elements;
  bool is_well_formed = true;

  [[nodiscard]] std::vector<XmlElement> named(const std::string& name) const {
    std::vector<XmlElement> found;
    for (const XmlElement& element : elements) {
      if (element.name == name) found.push_back(element);
    }
    return found;
  }

 protected:
  XmlReading() = default;
  ~XmlReading() override = default;

  void StartElement(const char* name, const char** attributes) override {
    XmlElement element{name, {}, {}, {}, static_cast<int>(open_.size())};
    if (!open_.empty()) element.parent = elements[open_.back()].name;
    for (const char** at = attributes; *at != nullptr; at += 2) element.attributes[at[0]] = at[1];
    open_.push_back(elements.size());
    elements.push_back(element);
  }
  void EndElement(const char* /*name*/) override { open_.pop_back(); }
  void CharacterDataHandler(const char* data, int length) override {
    elements[open_.back()].text.append(data, static_cast<std::size_t>(length));
  }
  void ReportXmlParseError() override { is_well_formed = false; }

 private:
  std::vector<std::size_t> open_;
};

inline XmlReading* XmlReading::New() { VTK_STANDARD_NEW_BODY(XmlReading); }

}  // namespace nadir
