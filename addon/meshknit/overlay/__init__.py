"""What is drawn over the mesh: time colours, knit graph, legend. overlay_data needs no Blender."""
