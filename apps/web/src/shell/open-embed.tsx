/**
 * The page in a frame of another site: stage, lines, task and the controls of a run. It has its own
 * simulator and storages that last as long as it does, so that it reads and stores nothing of the
 * visitor. public/first.js also blocks the browser's storages.
 */
import "../ui/base.css";
import "../ui/fonts/inter.css";
import { toolNames, helpKinds, type Rights } from "@corridor/challenge";
import { conditionKinds, MAX_RULES, menuActions } from "@corridor/program";
import { I18nextProvider } from "react-i18next";
import { EmbeddedContent, type View } from "../features/embed/embedded-content.ts";
import { FramePort } from "../features/embed/frame-port.ts";
import type { FrameRequest } from "@corridor/protocol";
import { RunReporter } from "../features/embed/report-run.ts";
import { LanguageProvider } from "../model/language-context.ts";
import type { PageParts } from "../model/page-parts.ts";
import { isProgramRefused } from "../model/run/run-button.ts";
import type { Services } from "../model/services.ts";
import { VolatileStorage } from "../model/storage/volatile-storage.ts";
import { ServicesProvider } from "../model/use-services.ts";
import { EmbeddedPage } from "./EmbeddedPage.tsx";
import { openStudentPage } from "./student-page.ts";

/** In a maze without a lesson, everything but the maze can be changed. */
const rights: Rights = {
  drivers: ["program"],
  maxLines: MAX_RULES,
  conditions: conditionKinds,
  actions: menuActions,
  edits: new Set(["condition", "number", "action", "otherwise", "order", "lines"]),
  maze: false,
  tools: new Set(toolNames),
  help: new Set(helpKinds),
};

/** Time until a busy short-link service is asked again, in ms. */
const WAIT_MS = 1_000;

export async function openPage({ root, words, language, screen }: PageParts): Promise<void> {
  await words.loadNamespaces(["embed", "runDetails"]);
  const { services } = openStudentPage({ words, screen, device: new VolatileStorage() });
  services.screen.setState({ isEmbedded: true });
  services.challenge.setState({ isInvited: false });
  const port = new FramePort(window);
  const reporter = new RunReporter(services, (report) => port.send(report));
  const content = new EmbeddedContent({
    services,
    rights,
    decode: async (link) => {
      const { decodeSharedLink } = await import("../model/address/shared-link.ts");
      return decodeSharedLink(link);
    },
    readShortLink: async (id) => {
      const { readShortLink } = await import("../model/address/short-link.ts");
      return readShortLink(
        id,
        (url) => fetch(url),
        async () => new Promise((resolve) => setTimeout(resolve, WAIT_MS)),
      );
    },
    onOpened: (view) => {
      reporter.restart();
      reportOpened(port, services, view);
    },
  });
  port.listen((request) => follow(request, content, services));
  root.render(
    <I18nextProvider i18n={words}>
      <ServicesProvider value={services}>
        <LanguageProvider value={language}>
          <EmbeddedPage
            content={content}
            onSize={(width, height) => port.sendSize(width, height)}
          />
        </LanguageProvider>
      </ServicesProvider>
    </I18nextProvider>,
  );
  port.send({ type: "ready" });
  const openAddress = () => {
    const [, , place, id = ""] = location.pathname.split("/");
    if (location.hash.length > 1) void content.open({ link: location.hash.slice(1) });
    else if (place === "m") void content.open({ id });
    else content.openNothing();
  };
  window.addEventListener("hashchange", openAddress);
  openAddress();
}

function follow(request: FrameRequest, content: EmbeddedContent, services: Services): void {
  if (request.type === "open") {
    void content.open("link" in request ? { link: request.link } : { id: request.id });
    return;
  }
  if (content.view.getState().view.kind !== "open") return;
  const { simulator, challenge } = services;
  if (request.type === "stop") simulator.send({ type: "pause" });
  else if (request.type === "reset") simulator.send({ type: "reset" });
  else if (!isProgramRefused(challenge.getState().rights)) simulator.send({ type: "run" });
}

function reportOpened(port: FramePort, { workspace, challenge }: Services, view: View): void {
  if (view.kind === "problem") {
    port.send({ type: "opened", ok: false, problem: view.problem });
    return;
  }
  const { lesson } = challenge.getState();
  const { maze } = workspace.getState();
  const name = lesson?.name || lesson?.tasks[0]?.name || maze.name;
  port.send({ type: "opened", ok: true, name, tasks: lesson?.tasks.length ?? 0 });
}
