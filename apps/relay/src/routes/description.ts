/** `/openapi.json`: the description of the API for machines, made once when the relay starts. */
import { Router } from "express";
import { describeApi } from "../openapi/document.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { openToAllSites } from "./security-headers.ts";

export function descriptionRoutes(): Router {
  const text = JSON.stringify(describeApi());
  const router = Router();
  router
    .route("/openapi.json")
    .all(openToAllSites)
    .get((_request, response) => {
      response.set("Cache-Control", "public, max-age=300").type("json").send(text);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
