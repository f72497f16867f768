// Visibility sampling as published: "A Mapping & Planning Algorithm for RoboCup Small Size League" (ZJUNlict, 2022),
// one graph per robot and query, nodes in a KD-tree, A* over the whole graph.
#pragma once

#include "planning/planner.h"

namespace regista {

/// The figures of BuildGraph and Sample_and_addPoints are lost. Rebuilt from the text:
/// - BuildGraph: begin with start and goal; look at every pair of nodes, those added meanwhile included; sample each
///   obstacle that blocks one. It ends with the stated goal: "For any pair of nodes in the graph, either the edge
///   between them is collision-free, or the obstacles that could cause collision are sampled."
/// - Sample_and_addPoints: as its text says: nothing for a marked obstacle; else mark and sample it, add the samples
///   that are free, and do the same for whatever covers the others. Written as a loop in place of the recursion.
/// - samples stand at r/cos(π/n), else neighbours could not see each other; eight near ones (the text says six, the
///   example eight); corners and end circles as graph/samples.h, which the text describes.
/// - what the KD-tree is asked: here whether a node is there already (nearer than 1 mm), since samples of touching
///   obstacles coincide.
class VisibilitySamplingSingle : public Planner {
 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;
};

}  // namespace regista
