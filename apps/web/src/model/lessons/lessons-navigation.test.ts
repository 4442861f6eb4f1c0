import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { setMaze, setProgram } from "../workspace/workspace-store.ts";
import { LessonsNavigation } from "./lessons-navigation.ts";
import { lines } from "./missions/mission.ts";
import { lessonsPage, noAddressBar } from "./testing/lessons-page.ts";

function openPage() {
  const page = lessonsPage();
  /** index of each maze whose run is judged */
  const judged: number[] = [];
  const attempt = { begin: (_challenge: unknown, maze: number) => void judged.push(maze) };
  const navigation = new LessonsNavigation(page.ports, attempt, noAddressBar);
  return { ...page, navigation, judged };
}

describe("navigation between missions", () => {
  it("opens each mission in a project of its own, and later where the student left it", () => {
    const { navigation, challenge, workspace, ports } = openPage();
    expect(navigation.openMission("one-line")).toBe(true);
    expect(challenge.getState().mission).toBe("one-line");
    const project = ports.projects.currentId();
    navigation.openMission("every-maze");
    expect(ports.projects.currentId()).not.toBe(project);
    navigation.openMission("one-line");
    expect(ports.projects.currentId()).toBe(project);
    expect(workspace.getState().maze).toEqual(challenge.getState().challenge?.mazes[0]);
  });

  it("opens nothing for an unknown mission", () => {
    const { navigation, challenge } = openPage();
    expect(navigation.follow("no-such-mission")).toBe(false);
    expect(challenge.getState().challenge).toBeNull();
  });

  it("returns to what was open before the first mission", () => {
    const { navigation, workspace, ports, sent } = openPage();
    navigation.openMission("one-line");
    navigation.openMission("every-maze");
    navigation.goHome();
    expect(ports.projects.currentId()).toBe("own");
    expect(workspace.getState()).toMatchObject({ maze: firstMaze, program: firstProgram });
    expect(sent.at(-1)).toEqual({ type: "driver", driver: "program" });
  });

  it("shows another maze of the challenge with the same program", () => {
    const { navigation, challenge, workspace, judged } = openPage();
    navigation.openMission("every-maze");
    const program = lines("reverse");
    setProgram(workspace, program);
    navigation.showMaze(1);
    expect(challenge.getState().maze).toBe(1);
    expect(workspace.getState().program).toEqual(program);
    expect(judged).toEqual([0, 1]);
  });

  it("closes a challenge whose maze the student replaces, and says so", () => {
    const { navigation, challenge, workspace, storage, messages } = openPage();
    navigation.openMission("one-line");
    setMaze(workspace, { ...firstMaze, name: "Mine" });
    expect(challenge.getState().challenge).toBeNull();
    expect(storage.record.works).toEqual({});
    expect(messages()).toMatchObject([{ text: "missions:card.replaced" }]);
  });

  it("stores a shared challenge with its project, and loads it with the project", () => {
    const { navigation, challenge, ports } = openPage();
    navigation.openMission("every-maze");
    const shared = challenge.getState().challenge;
    if (shared === null) throw new Error("no challenge");
    navigation.openShared(shared, null);
    const project = ports.projects.list().at(-1);
    navigation.goHome();
    if (project !== undefined) ports.projects.open(project);
    navigation.sync();
    expect(challenge.getState()).toMatchObject({ challenge: shared, mission: null });
  });
});
