/**
 * Entry of the dashboard's worker: the connection to the class and the pictures of the students, so
 * that the page only renders. A thin shell; the class is in `classroom-host.ts`.
 */
import type { Tile } from "@corridor/protocol";
import type { Classroom, FromClassroom, ToClassroom } from "../protocol/classroom-messages.ts";
import { CardPainter } from "./card-painter.ts";
import { ClassroomHost } from "./classroom-host.ts";
import { ScreenFeed } from "./screen-feed.ts";

const worker = self as unknown as DedicatedWorkerGlobalScope;
let host: ClassroomHost | null = null;

const painter = new CardPainter({
  tileOf: (student): Tile | null => host?.roster.tileOf(student) ?? null,
  requestFrame: (paint) => requestAnimationFrame(paint),
  now: () => performance.now(),
});

const screens = new ScreenFeed({
  tileOf: (student) => host?.roster.tileOf(student) ?? null,
  isSolved: (student, task) => painter.isVerified(student, task),
  send: (content, priority) => host?.send({ type: "display", content, priority }),
  after: (ms, call) => void setTimeout(call, ms),
});

function post(message: FromClassroom): void {
  const isNew = message.type === "status" && message.status.kind === "connected";
  const isFree = message.type === "displayed" && message.priority === null;
  if (isNew || isFree) screens.repeat();
  if (message.type === "lesson") painter.setLesson(message.lesson);
  worker.postMessage(message);
}

function open(room: Classroom): void {
  host ??= new ClassroomHost(room, {
    origin: worker.location.origin,
    now: () => Date.now(),
    after: (ms, call) => {
      const timer = setTimeout(call, ms);
      return () => clearTimeout(timer);
    },
    read: async (path, key) => {
      const answer = await fetch(path, { headers: { Authorization: `Bearer ${key}` } });
      return { status: answer.status, text: await answer.text() };
    },
    post,
    onTiles: (students) => {
      painter.changed(students);
      screens.changed(students);
    },
  });
}

worker.onmessage = ({ data }: MessageEvent<ToClassroom>) => {
  switch (data.type) {
    case "open":
      return open(data.room);
    case "again":
      return host?.again();
    case "watch":
    case "hint":
      return host?.send(data);
    case "screens":
      return screens.show(data);
    case "colours":
      return painter.setPalette(data.palette);
    case "calm":
      return painter.setCalm(data.isCalm);
    case "canvas":
      return painter.place(data.place, data.canvas);
    case "pictures":
      return painter.arrange(data.place, data.width, data.height, data.pictures);
    case "canvas-gone":
      return painter.remove(data.place);
    case "verified":
      return painter.setVerified(data.student, data.tasks);
  }
};
