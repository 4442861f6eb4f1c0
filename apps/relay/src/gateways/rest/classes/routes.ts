/** Classes: creation and end, joining, the lesson, and what the teacher sets. */
import { Router, type Request } from "express";
import type { ClassVerb } from "../../../classes/access.ts";
import type { LiveClass } from "../../../classes/live-class.ts";
import { lessonVersionOf, type ClassRegistry } from "../../../classes/registry.ts";
import type { Step } from "../../../classes/step.ts";
import {
  lessonStep,
  lockStep,
  newCodeStep,
  paceStep,
  pauseStep,
  resumeStep,
  returnCodeStep,
} from "../../../classes/teacher-steps.ts";
import { noClass } from "../../../platform/errors/problems.ts";
import { entityTag, matchesTag } from "../../../platform/http/entity-tags.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { readBearer } from "../../../platform/http/reading.ts";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import {
  readClassRequest,
  readJoin,
  readLessonBody,
  readPace,
  readPause,
  readStudent,
} from "./reading.ts";

export function classRoutes(registry: ClassRegistry, guard: RequestGuard): Router {
  const router = Router();

  const authorise = async (request: Request<{ id: string }>, verb: ClassVerb): Promise<LiveClass> =>
    (await registry.authorise(request.params.id, readBearer(request), verb)).found;

  router
    .route("/classes")
    .post(async (request, response) => {
      const { names, expected, lesson } = await readClassRequest(request, response);
      const created = await registry.create(
        // The schema orders the fields, so equal lessons have equal text.
        { names, expected, lesson: JSON.stringify(lesson) },
        guard.addressOf(request),
        guard.originOf(request),
      );
      response.status(201).location(`/api/v1/classes/${created.id}`).json(created);
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/joins")
    .post(async (request, response) => {
      const { code } = await readJoin(request, response);
      response.status(201).json(await registry.join(code, guard.addressOf(request)));
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/classes/:id")
    .get(async (request, response) => {
      response.json(await (await authorise(request, "inspect")).view());
    })
    .delete(async (request, response) => {
      await registry.remove(await authorise(request, "end"));
      response.status(204).end();
    })
    .all(methodNotAllowed("GET, DELETE"));

  router
    .route("/classes/:id/lesson")
    .get(async (request, response) => {
      const lesson = await (await authorise(request, "readLesson")).lesson();
      if (lesson === null) throw noClass();
      const tag = entityTag(lesson.version);
      response.set("ETag", tag);
      if (matchesTag(request.get("If-None-Match"), tag)) return void response.status(304).end();
      response.type("json").send(lesson.text);
    })
    .put(async (request, response) => {
      const found = await authorise(request, "direct");
      const text = JSON.stringify(await readLessonBody(request, response));
      const version = lessonVersionOf(text);
      await found.run(lessonStep(text, version));
      response.status(204).set("ETag", entityTag(version)).end();
    })
    .all(methodNotAllowed("GET, PUT"));

  /** A setting that PUT sets and DELETE resets. */
  const setting = (
    path: `/classes/:id/${string}`,
    set: (...parts: Parameters<typeof readPause>) => Promise<Step<void>>,
    reset: () => Step<void>,
  ): void => {
    router
      .route(path)
      .put(async (request: Request<{ id: string }>, response) => {
        const found = await authorise(request, "direct");
        await found.run(await set(request, response));
        response.status(204).end();
      })
      .delete(async (request: Request<{ id: string }>, response) => {
        await (await authorise(request, "direct")).run(reset());
        response.status(204).end();
      })
      .all(methodNotAllowed("PUT, DELETE"));
  };
  setting(
    "/classes/:id/pause",
    async (request, response) => pauseStep((await readPause(request, response)).seconds),
    resumeStep,
  );
  setting(
    "/classes/:id/pace",
    async (request, response) => paceStep((await readPace(request, response)).to),
    () => paceStep(null),
  );
  setting(
    "/classes/:id/lock",
    async () => lockStep(true),
    () => lockStep(false),
  );

  router
    .route("/classes/:id/code")
    .post(async (request, response) => {
      const code = await (await authorise(request, "direct")).run(newCodeStep());
      response.status(201).json({ code });
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/classes/:id/students/:student")
    .delete(async (request, response) => {
      const found = await authorise(request, "direct");
      await found.removeStudent(readStudent(request.params.student));
      response.status(204).end();
    })
    .all(methodNotAllowed("DELETE"));

  router
    .route("/classes/:id/students/:student/program")
    .get(async (request, response) => {
      const found = await authorise(request, "inspect");
      response.json(await found.program(readStudent(request.params.student)));
    })
    .all(methodNotAllowed("GET"));

  router
    .route("/classes/:id/students/:student/return")
    .post(async (request, response) => {
      const found = await authorise(request, "direct");
      const { code, seconds } = await found.run(
        returnCodeStep(readStudent(request.params.student)),
      );
      response.status(201).json({ code, endsInSeconds: seconds });
    })
    .all(methodNotAllowed("POST"));

  return router;
}
