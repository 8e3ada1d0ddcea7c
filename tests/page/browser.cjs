// SPDX-License-Identifier: MIT
// The browser that tests look at pages with, and what looks for barriers in them; with_browser.sh has both there.
"use strict";

const {chromium} = require("playwright-core");

exports.launch = () => chromium.launch({executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"]});

/** A script that gives a page the function `axe.run`. */
exports.axe = require("fs").readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
