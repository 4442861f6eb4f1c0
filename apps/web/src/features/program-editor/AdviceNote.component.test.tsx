import { useState } from "react";
import { expect, it } from "vitest";
import { page } from "vitest/browser";
import { renderWithServices } from "../../shell/testing/render-with-services.tsx";
import { AdviceNote } from "./AdviceNote.tsx";

const text = { reason: "Turn later.", fix: null };

/** A line with advice as soon as it is edited. */
function Line() {
  const [isEdited, setEdited] = useState(false);
  return (
    <li>
      <input aria-label="edited" onChange={() => setEdited(true)} />
      {isEdited && <AdviceNote text={text} onHide={() => {}} />}
    </li>
  );
}

it("advice that appears below the edited line scrolls into view", async () => {
  await renderWithServices(
    <ul style={{ blockSize: 90, overflowY: "auto" }}>
      <li style={{ blockSize: 60 }}>first</li>
      <Line />
    </ul>,
  );
  await page.getByLabelText("edited").fill("1");
  await expect.element(page.getByText(text.reason)).toBeInViewport({ ratio: 1 });
});
