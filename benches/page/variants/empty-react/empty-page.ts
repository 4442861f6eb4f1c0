/** A minimal React page that renders one word. */
import { createElement } from "react";
import { createRoot } from "react-dom/client";

const root = document.getElementById("root");
if (root === null) throw new Error("index.html has no #root");
createRoot(root).render(createElement("p", null, "Ready"));
