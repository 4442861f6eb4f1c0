/**
 * The student's stage and editor of lines in the lesson editor. Each finished edit becomes an edit of
 * the lesson, which has the only history.
 */
import { toolNames, type Rights } from "@corridor/challenge";
import { conditionKinds, MAX_RULES, menuActions } from "@corridor/program";
import { useEffect, useEffectEvent, useLayoutEffect, useRef, useState } from "react";
import { Stage } from "../features/maze-editor/Stage.tsx";
import { Messages } from "../features/messages/Messages.tsx";
import { ProgramEditor } from "../features/program-editor/ProgramEditor.tsx";
import { SpokenRun } from "../features/speech/SpokenRun.tsx";
import type { WorkbenchProps } from "../features/teach/frame/teach-slots.ts";
import type { Services } from "../model/services.ts";
import { ServicesProvider } from "../model/use-services.ts";
import { openProject } from "../model/workspace/workspace-store.ts";
import styles from "./lesson-workbench.module.css";
import { openStudentPage, type SurroundingPage } from "./student-page.ts";

/** Everything can be edited. Advice would be about a program that students complete. */
const teacherRights: Rights = {
  drivers: ["program"],
  maxLines: MAX_RULES,
  conditions: conditionKinds,
  actions: menuActions,
  edits: new Set(["condition", "number", "action", "otherwise", "order", "lines"]),
  maze: true,
  tools: new Set(toolNames),
  help: new Set(),
};

type LessonWorkbenchProps = WorkbenchProps & { page: SurroundingPage };

export function LessonWorkbench({ page, children, ...documents }: LessonWorkbenchProps) {
  const [student] = useState(() => openWorkbench(page, documents));
  useEffect(() => () => student.end(), [student]);
  useDocuments(student.services, documents);
  const stage = (
    <div className={styles["stage"]}>
      <Stage history={null} strip={null} sound={null} cards={() => null} />
      <Messages />
      <SpokenRun />
    </div>
  );
  return (
    <ServicesProvider value={student.services}>
      {children({ stage, lines: <ProgramEditor /> })}
    </ServicesProvider>
  );
}

function openWorkbench(
  page: SurroundingPage,
  { maze, program }: Pick<WorkbenchProps, "maze" | "program">,
) {
  const student = openStudentPage(page);
  const { workspace, challenge } = student.services;
  openProject(workspace, maze, program);
  challenge.setState({ rights: teacherRights });
  return student;
}

/** Displays the documents of the lesson, and reports those that were edited here. */
function useDocuments(
  { workspace, simulator }: Pick<Services, "workspace" | "simulator">,
  { maze, program, onMaze, onProgram }: Omit<WorkbenchProps, "children">,
): void {
  /** the documents that the lesson has */
  const known = useRef({ maze, program });
  useLayoutEffect(() => {
    const displayed = workspace.getState();
    known.current = { maze, program };
    if (displayed.maze === maze && displayed.program === program) return;
    openProject(workspace, maze, program);
    simulator.send({ type: "reset" });
  }, [workspace, simulator, maze, program]);
  const report = useEffectEvent((): void => {
    const before = known.current;
    const { maze: nextMaze, program: nextProgram } = workspace.getState();
    known.current = { maze: nextMaze, program: nextProgram };
    if (nextMaze !== before.maze) onMaze(nextMaze);
    if (nextProgram !== before.program) onProgram(nextProgram);
  });
  // The history of the workspace changes at the end of a stroke, not with each of its squares.
  useEffect(() => workspace.temporal.subscribe(() => report()), [workspace]);
}
