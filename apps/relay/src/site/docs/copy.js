/* Adds a copy button above each code block. The clipboard requires HTTPS or localhost. */
for (const block of navigator.clipboard ? document.querySelectorAll("pre") : []) {
  const bar = document.createElement("div");
  bar.className = "copy";
  const result = document.createElement("output");
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = "Copy";
  button.addEventListener("click", () => {
    navigator.clipboard.writeText(block.textContent).then(
      () => (result.textContent = "Copied"),
      () => (result.textContent = "Select the text and copy it yourself."),
    );
  });
  bar.append(result, button);
  block.before(bar);
}
