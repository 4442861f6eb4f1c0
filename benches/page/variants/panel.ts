/** A minimal panel: eight texts, updated 20 times per second. */
import { sensorNames } from "@corridor/protocol";
import type { RunFrame } from "./bench-run.ts";

export function createPanel(): (frame: RunFrame) => void {
  const panel = document.createElement("aside");
  const fields = Array.from({ length: 8 }, () => {
    const field = document.createElement("p");
    field.append("0");
    panel.append(field);
    return field;
  });
  document.body.append(panel);
  return ({ pose, sensors, tick }) => {
    const texts = [
      ...sensorNames.map((sensor) => sensors[sensor].toFixed(1)),
      `${Math.round(pose.x)}, ${Math.round(pose.y)}`,
      (tick / 60).toFixed(1),
      `${sensors.right.toFixed(1)} > 60`,
      `${sensors.front.toFixed(1)} < 50`,
    ];
    texts.forEach((text, at) => {
      const field = fields[at];
      if (field !== undefined && field.textContent !== text) field.textContent = text;
    });
  };
}
