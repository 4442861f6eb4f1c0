/**
 * The study of 2013: what its tables print and its data files do not contain. A task of a report is
 * the paper's if its times are those of table 10.
 */

export interface PaperTask {
  /** of the solution in figures 22 and 23, without "otherwise" */
  lines: number;
  /** its "lines of code" in table 6: one menu of the default, and two menus of each line */
  menus: number;
  /** the mean that table 6 prints, if the paper's text and data contradict it */
  misprint: string | null;
  /** table 10, one value per student */
  seconds: readonly number[];
}

const rightWall: PaperTask = {
  lines: 2,
  menus: 5,
  misprint: null,
  seconds: [
    30, 30, 40, 60, 60, 60, 135, 150, 180, 180, 180, 210, 240, 240, 300, 300, 330, 360, 360, 420,
    450, 480, 540, 540, 600, 780, 780, 840,
  ],
};

const farthestDistance: PaperTask = {
  lines: 3,
  menus: 7,
  misprint: "3:38",
  seconds: [
    240, 240, 360, 240, 270, 240, 120, 570, 70, 425, 425, 100, 480, 90, 90, 180, 360, 180, 120, 45,
    45, 300, 180, 300, 180, 225, 60, 240,
  ],
};

/** The task of the paper with these times, in this order, or null. */
export function paperTaskOf(seconds: readonly (number | null)[]): PaperTask | null {
  const tasks = [rightWall, farthestDistance];
  return tasks.find((task) => String(task.seconds) === String(seconds)) ?? null;
}
