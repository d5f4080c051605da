#include "server/workspace.h"

#include <algorithm>

namespace robcogen::server {

const Analysis& Workspace::analysis(const OpenDocument& document) {
  std::shared_ptr<const Analysis>& known = analyses_[document.uri];
  if (!known) known = analyse(document, documents_, robots_);
  return *known;
}

void Workspace::forget(const std::filesystem::path& changed) {
  std::erase_if(analyses_, [&](const auto& known) {
    const OpenDocument* document = documents_.find(known.first);
    const bool is_list = document != nullptr && document->language == driver::Language::desired;
    return document == nullptr || is_list || document->path == changed || known.second->read.contains(changed);
  });
}

void Workspace::forget_all() {
  analyses_.clear();
  std::erase_if(parsed_texts_, [&](const auto& known) { return documents_.find(known.first) == nullptr; });
  robots_.forget_files();
}

std::vector<Json> Workspace::publish(const std::string& shown) {
  PositionCache positions(encoding);
  std::map<std::string, std::map<std::filesystem::path, Json>> diagnostics;
  for (const auto& [uri, document] : documents_.all()) {
    const bool is_known = analyses_.contains(uri) && diagnostics_.contains(uri);
    diagnostics[uri] = is_known ? std::move(diagnostics_[uri])
                                : published(analysis(document).diagnostics, document, documents_, positions);
  }
  diagnostics_ = std::move(diagnostics);

  // Two documents may yield the same diagnostic of a third one.
  std::map<std::filesystem::path, Json> all;
  for (const auto& [uri, lists] : diagnostics_) {
    for (const auto& [path, list] : lists) {
      Json& target = all.try_emplace(path, Json::array()).first->second;
      for (const Json& d : list)
        if (std::find(target.begin(), target.end(), d) == target.end()) target.push_back(d);
    }
  }
  for (const auto& [path, list] : published_)
    if (!all.contains(path)) all[path] = Json::array();

  std::vector<Json> messages;
  for (const auto& [path, list] : all) {
    const OpenDocument* open = documents_.find(path);
    const auto before = published_.find(path);
    const bool is_new = before == published_.end() ? !list.empty() : before->second != list;
    if (!is_new && (open == nullptr || open->uri != shown)) continue;
    Json parameters = {{"uri", documents_.uri(path)}, {"diagnostics", list}};
    if (open != nullptr) parameters["version"] = open->version;
    messages.push_back(
        {{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(parameters)}});
  }
  published_ = std::move(all);
  std::erase_if(
      published_, [&](const auto& known) { return known.second.empty() && documents_.find(known.first) == nullptr; });
  return messages;
}

}  // namespace robcogen::server
