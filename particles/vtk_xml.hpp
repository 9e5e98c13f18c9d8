// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plenum {

/// A start tag ("Piece"), an end tag ("/Piece"), and the text up to the next tag.
struct VtkElement {
  std::string_view name;
  std::string_view attributes;
  std::string_view text;  ///< of AppendedData all that follows

  /// The value as it stands between the quotes; nothing if there is no such attribute.
  std::optional<std::string_view> attribute(std::string_view key) const;
};

/// Goes through the tags of a VTK file in XML. Only as much of XML as such files have: comments and
/// declarations are passed over, entities are left as they are. `bytes` must outlive this.
class VtkXml {
 public:
  /// `source` begins every message.
  VtkXml(std::string_view bytes, std::string source) : rest_(bytes), source_(std::move(source)) {}

  /// The next tag, nothing at the end. Throws InputError for a tag without an end.
  std::optional<VtkElement> next();

 private:
  void skipComments();

  std::string_view rest_;
  std::string source_;
};

}  // namespace plenum
