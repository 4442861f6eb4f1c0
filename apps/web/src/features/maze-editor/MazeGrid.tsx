/**
 * The maze as an ARIA grid for keyboard and screen readers, which lies invisibly over the drawn
 * maze. It also receives pointer events. Only the squares around the cursor are in the DOM, because
 * a maze can have 65,536 squares.
 */
import { sizeOf, type Cell } from "@corridor/maze";
import { useId, type KeyboardEvent, type RefObject } from "react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { asSentence, joinSentences } from "../../text/joined.ts";
import { classNames } from "../../ui/class-names.ts";
import { useAnnouncement } from "../../model/use-announcement.ts";
import { cellLabel } from "./cell-label.ts";
import { around, clampCell, moveCursor } from "./grid-cursor.ts";
import type { Facing } from "../../stage/page/robot-place.ts";
import { cellAtPoint, tapeWords } from "../../stage/page/tape.ts";
import type { StageController } from "./stage-controller.ts";
import styles from "./stage.module.css";
import { robotSquare, useRobotSquare } from "./use-robot-square.ts";

interface MazeGridProps {
  controller: StageController;
  element: RefObject<HTMLTableElement | null>;
}

export function MazeGrid({ controller, element }: MazeGridProps) {
  "use memo";
  const { workspace, screen, speech, run } = useServices();
  const { t, i18n } = useTranslation();
  const newestMaze = useStore(workspace, (state) => state.maze);
  // At a past tick the robot stands in the maze of that tick.
  const maze = useStore(run, (state) => state.pastMaze) ?? newestMaze;
  const layout = useStore(controller.view, (view) => view.layout);
  const chosen = useStore(controller.view, (view) => view.cursor);
  const helpId = useId();
  const size = sizeOf(maze);
  const isMeasuring = useStore(screen, ({ tool }) => tool === "measure");
  const tape = useStore(controller.view, (view) => view.tape);
  const cursor = clampCell(chosen ?? maze.start, size);
  const robot = useRobotSquare(cursor);
  const side = layout?.cellPx ?? 0;
  const labelOf = (cell: Cell, at: string): string =>
    cellLabel(t, maze, cell, robotFacingOn(at, cell));
  const robotNow = () => robotSquare(run.getState());

  // Screen readers announce the start of a tape and its final length, not each square between them.
  const tapeText =
    tape === null
      ? null
      : tape.isOpen
        ? t("stage.measured.from", {
            square: labelOf(clampCell(cellAtPoint(tape.from), size), robotNow()),
          })
        : joinSentences(
            t,
            tapeWords(t, i18n.language, tape).map((words) => asSentence(t, words)),
          );

  useAnnouncement(tapeText, "tape");

  function onKeyDown(event: KeyboardEvent<HTMLTableCellElement>): void {
    if (event.key === " " || event.key === "Enter") {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      if (isMeasuring) {
        controller.measure.press(cursor);
        return;
      }
      controller.editor.press(cursor);
      const is = cellLabel(t, workspace.getState().maze, cursor, robotFacingOn(robotNow(), cursor));
      speech.announce(is, "square");
      return;
    }
    const next = moveCursor(cursor, event, size);
    if (next === null) return;
    event.preventDefault();
    // The square must be in the DOM before it can receive the focus.
    flushSync(() => controller.view.setState({ cursor: next }));
    if (isMeasuring) controller.measure.aim(next);
    element.current?.querySelector<HTMLElement>('[tabindex="0"]')?.focus();
  }

  return (
    <>
      <table
        ref={element}
        // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-to-interactive-role -- ARIA's own pattern: a table becomes a grid
        role="grid"
        aria-label={t("stage.name")}
        aria-describedby={helpId}
        aria-rowcount={size.rows}
        aria-colcount={size.columns}
        className={classNames(
          layout?.overflows === true ? styles["gridScrolling"] : styles["grid"],
          isMeasuring ? styles["measuring"] : undefined,
        )}
        style={{
          left: layout?.origin.x,
          top: layout?.origin.y,
          width: side * size.columns,
          height: side * size.rows,
        }}
      >
        <tbody>
          {around(cursor.row, size.rows).map((row) => (
            <tr key={row} aria-rowindex={row + 1}>
              {around(cursor.column, size.columns).map((column) => (
                <td
                  key={column}
                  aria-colindex={column + 1}
                  aria-label={labelOf({ column, row }, robot)}
                  tabIndex={column === cursor.column && row === cursor.row ? 0 : -1}
                  className={styles["cell"]}
                  style={{ left: column * side, top: row * side, width: side, height: side }}
                  onKeyDown={onKeyDown}
                />
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      <p id={helpId} hidden>
        {t(isMeasuring ? "stage.measureHelp" : "stage.gridHelp")}
      </p>
    </>
  );
}

/**
 * The direction that the robot faces if it stands on this square.
 * @param robot "column,row,facing" or ""
 */
function robotFacingOn(robot: string, cell: Cell): Facing | null {
  const [column, row, facing] = robot.split(",");
  const isHere = Number(column) === cell.column && Number(row) === cell.row && robot !== "";
  return isHere ? (facing as Facing) : null;
}
