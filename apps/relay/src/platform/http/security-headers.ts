/** Security headers of all responses, and the CORS headers of the API. */
import type { RequestHandler, Response } from "express";
import helmet from "helmet";

const SELF = "'self'";

/**
 * Content-Security-Policy and related headers: only resources of this service are allowed.
 * @param isDevelopment hot reload injects inline scripts and styles into the page
 */
export function securityHeaders(isDevelopment: boolean): RequestHandler {
  const own = isDevelopment ? [SELF, "'unsafe-inline'"] : [SELF];
  return helmet({
    contentSecurityPolicy: {
      useDefaults: false,
      directives: {
        defaultSrc: [SELF],
        scriptSrc: own,
        styleSrc: own,
        // 'self' includes WebSockets of the same host.
        connectSrc: [SELF],
        workerSrc: [SELF],
        manifestSrc: [SELF],
        imgSrc: [SELF, "data:", "blob:"],
        fontSrc: [SELF],
        formAction: [SELF],
        objectSrc: ["'none'"],
        baseUri: ["'none'"],
        frameAncestors: ["'none'"],
        // Text never becomes markup or script. The page's only policy lists the workers that may
        // start.
        ...(!isDevelopment && {
          requireTrustedTypesFor: ["'script'"],
          trustedTypes: ["default"],
        }),
      },
    },
    referrerPolicy: { policy: "no-referrer" },
    // The proxy in front decides on HTTPS, not the relay.
    strictTransportSecurity: false,
    xFrameOptions: { action: "deny" },
  });
}

/** Allows one more Trusted Types policy on a page, for a library that creates one. */
export function allowPolicy(response: Response, name: string): void {
  const header = "Content-Security-Policy";
  const policy = String(response.getHeader(header));
  response.set(header, policy.replace("trusted-types default", `trusted-types default ${name}`));
}

/**
 * Allows other sites to show a page in a frame.
 * @param origins the only sites that may; null: all, also pages that were opened as a file
 */
export function allowFraming(response: Response, origins: readonly string[] | null): void {
  const header = "Content-Security-Policy";
  const ancestors = origins === null ? "" : `;frame-ancestors ${origins.join(" ")}`;
  const policy = String(response.getHeader(header));
  response.set(header, policy.replace(";frame-ancestors 'none'", ancestors));
  response.removeHeader("X-Frame-Options");
}

/** Scripts on any site may call the API, because authorisation uses keys only, never cookies. */
export const openToAllSites: RequestHandler = (request, response, next) => {
  response.set({
    "Access-Control-Allow-Origin": "*",
    "Access-Control-Expose-Headers": "ETag, Location, Retry-After",
    "Cross-Origin-Resource-Policy": "cross-origin",
    "Cache-Control": "no-store",
  });
  if (request.method !== "OPTIONS") return next();
  response
    .set({
      "Access-Control-Allow-Methods": "GET, POST, PUT, DELETE",
      "Access-Control-Allow-Headers":
        "Authorization, Content-Type, Idempotency-Key, If-None-Match, Last-Event-ID, Script-Clock, Script-Name",
      "Access-Control-Max-Age": "86400",
    })
    .status(204)
    .end();
  return undefined;
};
